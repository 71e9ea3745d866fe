#include "input/meshes/abaqus_words.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

namespace corpuscle {

namespace {

using Words = std::set<std::string>;

constexpr const char* first_order_solids = "mesh with linear elements: S3, S4R, C3D4, C3D8R";

/// Whether a type is of points, lines, springs or connectors: what has no surface for gas to press on, and no volume. gmsh writes the
/// lines of its geometry as T3D2.
bool is_line_or_point(const std::string& type)
{
    static const Words points{"MASS", "ROTARYI", "HEATCAP"};
    static constexpr std::array<const char*, 12> lines{"B2",  "B3",  "PIPE2",  "PIPE3", "ELBOW", "FRAME",
                                                       "T2D", "T3D", "SPRING", "DASH",  "CONN",  "GAP"};
    return points.contains(type) || std::any_of(lines.begin(), lines.end(), [&](const char* start) { return type.starts_with(start); });
}

/// What of an element of that type stands in the way.
std::string element_problem(const std::string& type)
{
    static const Words wedges{"C3D6", "C3D6T", "C3D5", "AC3D6", "DC3D6"};
    static const Words second{"S8R",     "S8R5",  "S8RT",  "STRI65", "S9R5",   "M3D6",    "M3D8",   "M3D8R",  "M3D9",   "C3D10", "C3D10M",
                              "C3D10HS", "C3D15", "C3D20", "C3D20R", "C3D20H", "C3D20RH", "C3D10H", "C3D10I", "C3D10T", "R3D6",  "C3D27",
                              "CPS6",    "CPS6M", "CPS8",  "CPS8R",  "CPE6",   "CPE8",    "CPE8R",  "DC3D10", "DC3D20"};
    if (type == "SC8R" || type == "SC6R" || type == "SC8RT")
        return fmt::format("elements of type {} are thick shells with nodes on both sides, which are not computed", type);
    if (wedges.contains(type)) return fmt::format("elements of type {} are wedges or pyramids, which are not computed", type);
    if (second.contains(type)) return fmt::format("elements of type {} are of second order, which are not computed", type);
    return fmt::format("elements of type '{}' are not known here", type);
}

}  // namespace

std::string unquoted_name(std::string_view text)
{
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
}

const std::string& AbaqusKeyword::of(const std::string& option) const
{
    static const std::string nothing;
    const auto found = options.find(option);
    return found == options.end() ? nothing : found->second;
}

bool next_abaqus_line(DeckLines& lines)
{
    while (lines.next())
        if (const std::string_view text = trimmed_field(lines.text()); !text.empty() && !text.starts_with("**")) return true;
    return false;
}

AbaqusKeyword abaqus_keyword(DeckLines& lines)
{
    std::string text(trimmed_field(lines.text()));
    while (text.ends_with(',') && next_abaqus_line(lines)) text += trimmed_field(lines.text());
    AbaqusKeyword keyword;
    for (const std::string_view field : comma_fields(std::string_view(text).substr(1))) {
        if (keyword.name.empty()) {
            for (const char c : in_capitals(field))
                if (c != ' ' || !keyword.name.ends_with(' ')) keyword.name += c;
            continue;
        }
        const std::size_t equals = std::min(field.find('='), field.size());
        const std::string_view value = equals == field.size() ? std::string_view{} : trimmed_field(field.substr(equals + 1));
        keyword.options[in_capitals(trimmed_field(field.substr(0, equals)))] = unquoted_name(value);
    }
    return keyword;
}

AbaqusElement abaqus_element(const DeckLines& lines, const std::string& type)
{
    static const Words triangles{"S3", "S3R", "S3RS", "S3T", "S3RT", "STRI3", "DS3", "M3D3", "R3D3", "SFM3D3", "CPS3", "CPE3"};
    static const Words quadrilaterals{"S4",    "S4R",  "S4RS",   "S4RSW",   "S4R5", "S4T",   "S4RT",  "DS4",  "M3D4",
                                      "M3D4R", "R3D4", "SFM3D4", "SFM3D4R", "CPS4", "CPS4R", "CPS4I", "CPE4", "CPE4R"};
    static const Words tetrahedra{"C3D4", "C3D4H", "C3D4T", "DC3D4"};
    static const Words hexahedra{"C3D8", "C3D8R", "C3D8I", "C3D8H", "C3D8S", "C3D8IH", "C3D8RH", "C3D8T", "C3D8RT", "DC3D8"};
    const std::string name = in_capitals(type);
    if (triangles.contains(name)) return {ElementShape::triangle, 3};
    if (quadrilaterals.contains(name)) return {ElementShape::quadrilateral, 4};
    if (tetrahedra.contains(name)) return {ElementShape::tetrahedron, 4};
    if (hexahedra.contains(name)) return {ElementShape::hexahedron, 8};
    if (is_line_or_point(name)) return {std::nullopt, 0};
    lines.fail(element_problem(name), first_order_solids);
}

const char* abaqus_refusal(const std::string& keyword)
{
    if (keyword == "NMAP" || keyword == "SUBMODEL") return "it makes or moves nodes of others";
    if (keyword == "MATRIX INPUT" || keyword == "IMPORT") return "it takes its mesh from elsewhere";
    if (keyword == "PARAMETER") return "what stands in <> could not be computed";
    return nullptr;
}

}  // namespace corpuscle
