#include "input/meshes/dyna_sets.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

namespace corpuscle {

namespace {

/// What the names of sets of that kind begin with.
const char* prefix_of(DynaSetKind kind)
{
    static constexpr std::array<const char*, 5> prefixes{"node_set", "part_set", "shell_set", "solid_set", "segment_set"};
    return prefixes[static_cast<std::size_t>(kind)];
}

bool is_of_nodes(DynaSetKind kind)
{
    return kind == DynaSetKind::nodes || kind == DynaSetKind::segments;
}

}  // namespace

std::int64_t dyna_number(const DynaCards& cards, const std::vector<std::string_view>& fields, std::size_t index, const char* what)
{
    if (index >= fields.size()) return 0;
    const std::int64_t value = integer_field(cards.lines(), fields[index], what);
    if (value < 0 || value >= dyna_solid_numbers)
        cards.lines().fail(fmt::format("{} where {} was expected", value, what), "numbers begin at 1");
    return value;
}

std::int64_t dyna_needed(const DynaCards& cards, const std::vector<std::string_view>& fields, std::size_t index, const char* what)
{
    const std::int64_t value = dyna_number(cards, fields, index, what);
    if (value == 0) cards.lines().fail(fmt::format("{} is missing", what), "correct the line, or export the mesh again");
    return value;
}

std::int64_t dyna_shifted(const DynaCards& cards, std::int64_t number, std::int64_t shift)
{
    const std::int64_t value = number + shift;
    if (value < 1 || value >= dyna_solid_numbers)
        cards.lines().fail(fmt::format("{} becomes {} in the file that includes this one", number, value),
                           "correct the offsets of *INCLUDE_TRANSFORM: numbers begin at 1");
    return value;
}

bool DynaSets::begin(DynaSetKind kind, const std::string& options)
{
    kind_ = kind;
    set_ = nullptr;
    title_.clear();
    std::string form;
    titled_ = false;
    for (std::string left = options; !left.empty();) {
        const std::size_t next = std::min(left.find('_', 1), left.size());
        const std::string option = left.substr(0, next);
        left.erase(0, next);
        if (option == "_TITLE")
            titled_ = true;
        else if (option != "_LIST" && option != "_COLLECT")
            form += option;
    }
    form_ = form;
    const bool general = form == "_GENERAL" && (kind == DynaSetKind::nodes || kind == DynaSetKind::shells || kind == DynaSetKind::solids);
    const bool ranges = form == "_GENERATE" || form == "_GENERATE_INCREMENT";
    const bool known = form.empty() || form == "_COLUMN" || form == "_ADD" || ranges || general;
    cards_.blanks_count = known && titled_;
    return known;
}

void DynaSets::read()
{
    if (titled_) {
        title_ = trimmed_field(cards_.text());
        titled_ = cards_.blanks_count = false;
        return;
    }
    if (set_ == nullptr) return open_set();
    if (form_ == "_GENERAL") return read_general();
    if (form_.starts_with("_GENERATE")) return read_ranges();
    const auto& card = cards_.fields(8, 10);
    const std::size_t most = kind_ == DynaSetKind::segments ? 4 : form_ == "_COLUMN" ? 1 : card.size();
    for (std::size_t i = 0; i < std::min(most, card.size()); ++i) {
        const std::int64_t member = dyna_number(cards_, card, i, "a member of a set");
        if (member == 0) continue;
        if (form_ == "_ADD")
            add_set(fmt::format("{}_{}", prefix_of(kind_), dyna_shifted(cards_, member, cards_.file().set)), false);
        else
            add(kind_, member, member);
    }
}

/// The set of the number on the present card; its title names the same.
void DynaSets::open_set()
{
    const std::int64_t id = dyna_needed(cards_, cards_.fields(8, 10), 0, "the number of a set");
    const std::string name = fmt::format("{}_{}", prefix_of(kind_), dyna_shifted(cards_, id, cards_.file().set));
    const auto set_named = [&](const std::string& key) -> NumberedMesh::Set& {
        return is_of_nodes(kind_) ? mesh_.node_set(key, key) : mesh_.element_set(key, key);
    };
    set_ = &set_named(name);
    if (!title_.empty() && title_ != name) set_named(title_).members.push_back({0, 0, 1, name, false, cards_.lines().place()});
}

void DynaSets::read_ranges()
{
    const auto& card = cards_.fields(8, 10);
    const bool stepped = form_ == "_GENERATE_INCREMENT";
    for (std::size_t i = 0; i < (stepped ? std::min<std::size_t>(card.size(), 1) : card.size()); i += 2) {
        const std::int64_t first = dyna_number(cards_, card, i, "the first of a range");
        if (first == 0) continue;
        const std::int64_t step = stepped ? dyna_needed(cards_, card, 2, "the step of a range") : 1;
        add(kind_, first, dyna_needed(cards_, card, i + 1, "the last of a range"), step);
    }
}

/// What a line of a general set adds: its first field says what the numbers are.
void DynaSets::read_general()
{
    const auto& card = cards_.fields(8, 10);
    const std::string what = in_capitals(card[0]);
    if (what == "ALL") return add(kind_, 1, dyna_solid_numbers - 1);
    static const std::map<std::string, DynaSetKind> sets{{"SET_NODE", DynaSetKind::nodes},
                                                         {"SET_PART", DynaSetKind::parts},
                                                         {"SET_SHELL", DynaSetKind::shells},
                                                         {"SET_SOLID", DynaSetKind::solids}};
    const auto set = sets.find(what);
    const bool own = what == (kind_ == DynaSetKind::nodes ? "NODE" : "ELEM");
    const bool of_set = set != sets.end() && (kind_ == DynaSetKind::nodes || !is_of_nodes(set->second));
    if (!own && what != "PART" && !of_set)
        cards_.lines().fail(fmt::format("'{}' in a general set is not read", shown_field(what)),
                            "give ALL, NODE, ELEM, PART or SET_..., or list the members");
    for (std::size_t i = 1; i < card.size(); ++i) {
        const std::int64_t member = dyna_number(cards_, card, i, "a member of a set");
        if (member == 0) continue;
        if (of_set)
            add_set(fmt::format("{}_{}", prefix_of(set->second), dyna_shifted(cards_, member, cards_.file().set)),
                    kind_ == DynaSetKind::nodes && !is_of_nodes(set->second));
        else
            add(own ? kind_ : DynaSetKind::parts, member, member);
    }
}

std::int64_t DynaSets::shift_of(DynaSetKind kind) const
{
    const DynaFile& file = cards_.file();
    return is_of_nodes(kind) ? file.node : kind == DynaSetKind::parts ? file.part : file.element;
}

void DynaSets::add_set(const std::string& name, bool of_elements)
{
    set_->members.push_back({0, 0, 1, name, of_elements, cards_.lines().place()});
}

void DynaSets::add(DynaSetKind kind, std::int64_t first, std::int64_t last, std::int64_t step)
{
    const bool everything = first == 1 && last == dyna_solid_numbers - 1;
    const std::int64_t shift = everything ? 0 : shift_of(kind), solids = kind == DynaSetKind::solids ? dyna_solid_numbers : 0;
    const std::int64_t from = dyna_shifted(cards_, first, shift), to = dyna_shifted(cards_, last, shift);
    if (last < first) cards_.lines().fail("the range of a set runs backwards", "give the first and the last number of the range");
    const DeckPlace place = cards_.lines().place();
    if (kind == DynaSetKind::parts)
        parts_.push_back({set_, from, to, kind_ == DynaSetKind::nodes, place});
    else
        set_->members.push_back({from + solids, to + solids, step, "", false, place});
}

std::set<std::int64_t> DynaSets::add_parts(const std::set<std::int64_t>& parts_with_elements)
{
    std::set<std::int64_t> missing;
    for (const Parts& parts : parts_) {
        if (parts.first == parts.last && !parts_with_elements.contains(parts.first)) missing.insert(parts.first);
        const auto end = parts_with_elements.upper_bound(parts.last);
        for (auto part = parts_with_elements.lower_bound(parts.first); part != end && *part <= parts.last; ++part)
            parts.set->members.push_back({0, 0, 1, fmt::format("part_{}", *part), parts.nodes, parts.place});
    }
    return missing;
}

std::string DynaSets::node_set_name(std::int64_t id)
{
    return fmt::format("{}_{}", prefix_of(DynaSetKind::nodes), id);
}

}  // namespace corpuscle
