#pragma once

#include <map>
#include <optional>
#include <string>

#include "input/meshes/deck_lines.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// A keyword line: "*NSET, NSET=edge, GENERATE". Names in capitals, values as written.
struct AbaqusKeyword {
    std::string name;
    std::map<std::string, std::string> options;

    [[nodiscard]] bool has(const std::string& option) const { return options.contains(option); }
    [[nodiscard]] const std::string& of(const std::string& option) const;  ///< empty if not given
};

/// A name without the quotes that may stand about it.
[[nodiscard]] std::string unquoted_name(std::string_view text);

/// Goes to the next line that is no comment and not blank; false behind the last.
[[nodiscard]] bool next_abaqus_line(DeckLines& lines);

/// The keyword of the present line, and of those it goes on in after a comma at its end.
[[nodiscard]] AbaqusKeyword abaqus_keyword(DeckLines& lines);

/// What a type of element is here: its shape, none for points, lines and springs, which are only in sets and have any number of nodes.
struct AbaqusElement {
    std::optional<ElementShape> shape;
    int corners = 0;
};

/// The type of that name; refuses, at the present line, others, with what would do instead.
[[nodiscard]] AbaqusElement abaqus_element(const DeckLines& lines, const std::string& type);

/// Why a keyword cannot be passed over, null if it can.
[[nodiscard]] const char* abaqus_refusal(const std::string& keyword);

}  // namespace corpuscle
