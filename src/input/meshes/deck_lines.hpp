#pragma once

#include <cstdint>
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
    /// Lets `next` give the present line once more.
    void hold() { held_ = true; }
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] DeckPlace place() const { return place_; }

    /// Goes on with the lines of a file, named as in the deck: beside the file that names it, or with its full path.
    /// Refuses a file that includes itself.
    void include(const std::string& name);

    /// Errors at the present line, or at an earlier one.
    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const { fail_at(place_, problem, remedy); }
    [[noreturn]] void fail_at(const DeckPlace& place, const std::string& problem, const std::string& remedy) const;

private:
    struct Open {
        Scanner scanner;
        DeckPlace place;
    };

    std::vector<std::string> files_;  ///< names of all that were read
    std::vector<Open> open_;          ///< the deck, and those included that are not at their end; the last is read
    std::string text_;
    DeckPlace place_;
    bool held_ = false;
};

/// A text without blanks at both ends.
[[nodiscard]] std::string_view trimmed_field(std::string_view text);

/// A text in capital letters.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// What stands between commas, without blanks; nothing behind a comma at the end of the line.
[[nodiscard]] std::vector<std::string_view> comma_fields(std::string_view line);

/// Number of a field; 0 if it is blank. Refuses what is none, at the present line, saying that `what` was expected. Reals also as Fortran
/// writes them ("1.5D-3", "1.5-3").
[[nodiscard]] double real_field(const DeckLines& lines, std::string_view field, const char* what);
[[nodiscard]] std::int64_t integer_field(const DeckLines& lines, std::string_view field, const char* what);

}  // namespace corpuscle
