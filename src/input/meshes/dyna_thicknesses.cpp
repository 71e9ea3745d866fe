#include "input/meshes/dyna_thicknesses.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace corpuscle {

bool DynaThicknesses::begin(const std::string& options)
{
    has_titles_ = options == "_TITLE";
    own_cards_ = false;
    line_ = has_titles_ ? -1 : 0;
    cards_.blanks_count = has_titles_;
    return options.empty() || has_titles_;
}

/// A title, if there are titles; number, formulation, ..., number of points and whether it is a laminate; thicknesses at the corners.
void DynaThicknesses::read()
{
    if (line_ > 0 && own_cards_) return;
    const int line = line_++;
    cards_.blanks_count = false;
    if (line == 0) read_first_card();
    if (line == 1) thickness_[section_] = real_field(cards_.lines(), cards_.fields(1, 10)[0], "a thickness");
    if (line < 1 + angle_lines_) return;
    line_ = has_titles_ ? -1 : 0;
    cards_.blanks_count = has_titles_;
}

/// Elements of a user's own have cards of their own: what follows is then left.
void DynaThicknesses::read_first_card()
{
    constexpr std::int64_t own_elements = 101, most_points = 10'000;
    const auto& card = cards_.fields(8, 10);
    const auto field = [&](std::size_t index) {
        return index < card.size() ? integer_field(cards_.lines(), card[index], "a number of a section") : 0;
    };
    section_ = field(0) + cards_.file().part;
    own_cards_ = field(1) >= own_elements;
    angle_lines_ = field(6) == 0 ? 0 : static_cast<int>((std::clamp<std::int64_t>(field(3), 1, most_points) + 7) / 8);
}

std::string DynaThicknesses::remark(const std::set<std::int64_t>& parts) const
{
    constexpr int most = 20;
    std::string text;
    int told = 0;
    for (const std::int64_t part : parts) {
        const auto section = section_of_.find(part);
        const auto thickness = section == section_of_.end() ? thickness_.end() : thickness_.find(section->second);
        if (thickness == thickness_.end() || thickness->second == 0 || ++told > most) continue;
        text += fmt::format("{}part_{} {:.6g}", told == 1 ? "" : ", ", part, thickness->second);
    }
    if (told == 0) return "";
    const std::string rest = told > most ? fmt::format(" and {} more", told - most) : "";
    return fmt::format("thicknesses in the file, in its unit, which do not count (the case says them): {}{}", text, rest);
}

}  // namespace corpuscle
