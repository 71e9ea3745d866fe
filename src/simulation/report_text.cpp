#include "simulation/report_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace corpuscle {

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            case '\'': result += "&#39;"; break;
            default: result += letter;
        }
    }
    return result;
}

std::string spaced(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string capitalized(std::string name)
{
    if (!name.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

std::string grouped(std::uint64_t number)
{
    std::string digits = std::to_string(number);
    for (std::size_t position = digits.size(); position > 3; position -= 3) digits.insert(position - 3, ",");
    return digits;
}

std::string rounded(double value, int digits)
{
    if (std::isnan(value)) return "-";
    const double size = std::abs(value);
    const bool plain = size == 0 || (size >= 1e-3 && size < 1e6) || std::isinf(value);
    if (!plain) return fmt::format("{:.{}e}", value, digits - 1);
    if (size >= std::pow(10.0, digits)) return fmt::format("{:.0f}", value);
    return fmt::format("{:.{}g}", value, digits);
}

std::string percentage(double fraction)
{
    if (std::isnan(fraction)) return "not a number";
    if (std::isinf(fraction)) return "infinite";
    if (fraction != 0 && std::abs(fraction) < 1e-6) return fmt::format("{:.1e}", fraction);
    return rounded(100 * fraction, 3) + " %";
}

}  // namespace corpuscle
