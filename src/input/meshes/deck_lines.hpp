#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/meshes/scanner.hpp"

namespace corpuscle {

/// Where a line of a deck stands.
struct DeckPlace {
    std::uint32_t file = 0;  ///< index of the files read
    std::uint32_t line = 0;  ///< counted from 1
};

/// The lines of a deck and of the files it includes, in the order in which they count.
class DeckLines {
public:
    explicit DeckLines(Scanner deck);

    /// Moves to the next line; false behind the last. An included file's lines come before what follows in the including one.
    bool next();
    /// The line that follows the present one in its own file, if there is one.
    [[nodiscard]] std::optional<std::string_view> following() const;
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] DeckPlace place() const { return place_; }

    /// Goes on with the lines of a file, named as in the deck: with its full path, beside the file that names it, or in one of the
    /// folders. Refuses a file that includes itself. The index of the file, as in the place of its lines.
    std::uint32_t include(const std::string& name, const std::vector<std::string>& folders = {});
    /// Passes over what is left of the present file, and goes on in the one that included it.
    void leave() { open_.back().scanner.skip_rest(); }
    /// Whether the present line stands in that file, or in one that it includes.
    [[nodiscard]] bool within(std::uint32_t file) const;
    /// The folder of the present file.
    [[nodiscard]] std::string folder() const;

    /// Errors at the present line, or at an earlier one.
    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const { fail_at(place_, problem, remedy); }
    [[noreturn]] void fail_at(const DeckPlace& place, const std::string& problem, const std::string& remedy) const;

private:
    struct Open {
        Scanner scanner;
        DeckPlace place;
        std::size_t depth = 0;  ///< how many files it is included by
    };

    /// Calls for the present file and those that include it, from the inside out, until `found` says so.
    template <class Found>
    bool any_around(const Found& found) const
    {
        auto open = open_.rbegin();
        while (open != open_.rend() && open->place.file != place_.file) ++open;
        for (std::size_t depth = open == open_.rend() ? 0 : open->depth; open != open_.rend(); ++open) {
            if (open->depth != depth) continue;
            if (found(open->place.file)) return true;
            if (depth-- == 0) return false;
        }
        return false;
    }

    std::vector<std::string> files_;  ///< names of all that were read
    std::vector<Open> open_;          ///< the deck, and those included that are not at their end; the last is read next
    std::string text_;
    DeckPlace place_;
};

/// A text without blanks at both ends.
[[nodiscard]] std::string_view trimmed_field(std::string_view text);

/// A text in capital letters.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// What stands between commas, without blanks; nothing behind a comma at the end of the line.
[[nodiscard]] std::vector<std::string_view> comma_fields(std::string_view line);

/// The field as a message shows it: short, without control characters.
[[nodiscard]] std::string shown_field(std::string_view field);

/// Number of a field; 0 if it is blank. Refuses what is none, at the present line, saying that `what` was expected. Reals also as Fortran
/// writes them ("1.5D-3", "1.5-3").
[[nodiscard]] double real_field(const DeckLines& lines, std::string_view field, const char* what);
[[nodiscard]] std::int64_t integer_field(const DeckLines& lines, std::string_view field, const char* what);

}  // namespace corpuscle
