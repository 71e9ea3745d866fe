#include "input/curves.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "input/placed.hpp"
#include "input/shapes.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

using Points = std::vector<std::pair<double, double>>;

/// What stands between commas, semicolons, tabs and blanks.
std::vector<std::string> columns_of(std::string line)
{
    std::replace_if(line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\r'; }, ' ');
    std::vector<std::string> columns;
    for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos; at = line.find_first_not_of(' ', at)) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        columns.push_back(line.substr(at, end - at));
        at = end;
    }
    return columns;
}

std::optional<double> number_of(const std::string& text)
{
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    double value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// Adds a line's point; a heading is a line without numbers before all points.
void add_line(Points& points, const std::string& line, const Place& place)
{
    const std::vector<std::string> columns = columns_of(line);
    if (columns.empty() || columns.front().starts_with('#')) return;
    const auto time = number_of(columns.front());
    if (!time && points.empty()) return;
    const auto value = columns.size() == 2 ? number_of(columns.back()) : std::nullopt;
    if (!time || !value)
        throw InputError(fmt::format("'{}' is not a time and a value", line.substr(0, 60)), "expected two numbers, such as 0.001, 3e5",
                         place);
    if (!points.empty() && !(*time > points.back().first))
        throw InputError(fmt::format("the times do not rise: {:.6g} after {:.6g}", *time, points.back().first),
                         "expected each time later than the one before", place);
    points.emplace_back(*time, *value);
}

Points read_points_file(const CurveFileInput& input, const std::string& unit, const CaseDescription& description)
{
    const std::string file = file_beside(input.file, description);
    std::ifstream stream(file);
    if (!stream || !std::filesystem::is_regular_file(file))
        throw InputError(fmt::format("there is no curve file '{}'", file), "expected a file beside the case, or its full path",
                         input.places.of("file"));
    Points points;
    int number = 0;
    for (std::string line; std::getline(stream, line);) add_line(points, line, {file, ++number, 1});
    if (points.empty()) throw InputError("the file has no points", "expected lines of a time and a value", {file, std::max(number, 1), 1});
    const double seconds = at_place(input.places.of("time_unit"), [&] { return convert("1 " + input.time_unit, "s"); });
    const double factor =
        input.scale * (input.unit.empty() ? 1.0 : at_place(input.places.of("unit"), [&] { return convert("1 " + input.unit, unit); }));
    for (auto& [time, value] : points) {
        time *= seconds;
        value *= factor;
    }
    return points;
}

}  // namespace

TimeCurve make_curve(const CurveInput& input, const std::string& unit, const CaseDescription& description)
{
    return TimeCurve(input.file ? read_points_file(*input.file, unit, description) : input.points);
}

}  // namespace corpuscle
