#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/meshes/affine_map.hpp"
#include "input/meshes/arithmetic.hpp"
#include "input/meshes/deck_lines.hpp"

namespace corpuscle {

/// How wide the fields of a deck's cards are.
enum class DynaFormat { standard, ten_columns, long_fields };

/// What holds for the lines of one file of a deck: how they are written, and how the file that includes it shifts and places them.
struct DynaFile {
    DynaFormat format = DynaFormat::standard;
    std::int64_t node = 0, element = 0, part = 0, set = 0, definition = 0;  ///< added to numbers
    AffineMap placed;
};

/// The cards of an LS-DYNA deck, with its parameters put in: lines that are no comments, split into fields.
class DynaCards {
public:
    explicit DynaCards(Scanner scanner) : lines_(std::move(scanner)), files_(1) {}

    /// The next line that is no comment and not blank; blank ones, too, while `blanks_count` (titles may be blank).
    bool next();
    /// The next line, if it belongs to the present keyword; refuses another.
    void next_of_keyword(const char* what);
    /// Goes to the next line, blank or not, that belongs to the present keyword and file; false if there is none.
    bool next_in_keyword();
    bool blanks_count = false;

    [[nodiscard]] const DeckLines& lines() const { return lines_; }
    [[nodiscard]] std::string_view text() const { return lines_.text(); }
    [[nodiscard]] DynaFile& file() { return files_[lines_.place().file]; }
    [[nodiscard]] const DynaFile& file() const { return files_[lines_.place().file]; }
    /// Goes back to the file that includes the present one.
    void leave() { lines_.leave(); }

    /// How the lines of the present keyword are written; that of the file unless the keyword says otherwise.
    void set_format(DynaFormat format) { format_ = format; }

    /// Fields of the present card. Widths are those of standard cards; in the long format all are 20 wide, with ten columns those of 8.
    /// They are good until the next call.
    [[nodiscard]] const std::vector<std::string_view>& fields(std::size_t count, std::size_t width);
    [[nodiscard]] const std::vector<std::string_view>& node_fields();

    /// Names of files to include on the present line and those that follow, put in place as `as` says; in `folders`, too.
    void include_list(const std::vector<std::string>& folders);
    void include(const std::string& name, const DynaFile& as, const std::vector<std::string>& folders);
    /// A file's name on the present line, which goes on in the next after " +".
    [[nodiscard]] std::string file_name();

    /// *PARAMETER: names, each with its kind before it (R, I, C), and values. *PARAMETER_EXPRESSION: one name and how it is computed, also
    /// on lines that follow with ten blanks before them. Options _LOCAL (for this file and those it includes) and _MUTABLE (may be given
    /// anew).
    void begin_parameters(const std::string& options);
    void read_parameters();

private:
    struct Parameter {
        DeckNumber number;
        std::string text;        ///< of one of characters
        std::uint32_t file = 0;  ///< which gave it
        bool local = false, is_text = false, may_change = false;
    };

    void split(const std::size_t* widths, std::size_t count);
    [[nodiscard]] std::string_view with_parameters(std::string_view field);
    [[nodiscard]] const Parameter& parameter(const std::string& name) const;
    [[nodiscard]] DeckNumber number_of(const std::string& name) const;
    [[nodiscard]] DeckNumber evaluated(std::string_view expression) const;
    void define(std::string_view named, std::string_view value, bool expression);
    void read_expression();

    DeckLines lines_;
    std::vector<DynaFile> files_;  ///< by their index
    DynaFormat format_ = DynaFormat::standard;
    std::vector<std::string_view> fields_;
    std::vector<std::string> replaced_;  ///< fields of the present card that parameters have been put into
    std::map<std::string, std::vector<Parameter>> parameters_;
    std::string parameter_options_;
};

}  // namespace corpuscle
