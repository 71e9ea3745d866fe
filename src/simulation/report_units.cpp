#include "simulation/report_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "simulation/report_text.hpp"

namespace corpuscle {

namespace {

constexpr std::array<std::string_view, 8> prefixes{"n", "µ", "m", "", "k", "M", "G", "T"};
constexpr int plain_prefix = 3;

bool takes_prefix(const std::string& unit)
{
    if (unit == "m" || unit == "s") return true;
    const std::string first = unit.substr(0, unit.find_first_of(" /"));
    return first == "Pa" || first == "J" || first == "N" || first == "W";
}

}  // namespace

ShownUnit shown_unit(const std::string& unit, double size)
{
    if (unit.empty() || unit == "1") return {1, ""};
    if (!takes_prefix(unit) || !(size > 0) || !std::isfinite(size)) return {1, unit};
    const int highest = static_cast<int>(prefixes.size()) - 1 - plain_prefix;
    // A hair is added, so that 1 - 1e-16 counts as 1.
    const auto power = static_cast<int>(std::floor(std::log10(size) / 3 + 1e-9));
    const int thousands = std::clamp(power, -plain_prefix, unit == "m" || unit == "s" ? 0 : highest);
    const int index = plain_prefix + thousands;
    return {std::pow(1000.0, thousands), std::string(prefixes.at(index)) + unit};
}

std::string shown_value(double value, const std::string& unit)
{
    if (std::isnan(value)) return "-";
    const ShownUnit shown = shown_unit(unit, std::abs(value));
    return rounded(value / shown.factor) + (shown.unit.empty() ? "" : " " + shown.unit);
}

}  // namespace corpuscle
