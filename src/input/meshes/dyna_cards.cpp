#include "input/meshes/dyna_cards.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace corpuscle {

namespace {

constexpr std::size_t most_fields = 10;

bool is_blank_line(std::string_view line)
{
    return trimmed_field(line).empty();
}

/// What stands between tabs and blanks: for lines with tabs, which have no columns.
std::vector<std::string_view> fields_between_blanks(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (line = trimmed_field(line); !line.empty(); line = trimmed_field(line)) {
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        fields.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return fields;
}

/// A value as a field would have it: what is whole without a point.
std::string written(const DeckNumber& number)
{
    constexpr double whole_below = 1e15;
    const bool whole = number.value == std::trunc(number.value) && std::fabs(number.value) < whole_below;
    return whole ? fmt::format("{}", static_cast<std::int64_t>(number.value)) : fmt::format("{}", number.value);
}

}  // namespace

bool DynaCards::next()
{
    while (lines_.next()) {
        if (lines_.text().starts_with('$')) continue;
        if (blanks_count || !is_blank_line(lines_.text())) return true;
    }
    return false;
}

void DynaCards::next_of_keyword(const char* what)
{
    if (!next() || lines_.text().starts_with('*')) lines_.fail(fmt::format("{} is missing", what), "export the mesh again");
}

bool DynaCards::next_in_keyword()
{
    for (auto more = lines_.following(); more && !more->starts_with('*'); more = lines_.following()) {
        lines_.next();
        if (!more->starts_with('$')) return true;
    }
    return false;
}

const std::vector<std::string_view>& DynaCards::fields(std::size_t count, std::size_t width)
{
    std::array<std::size_t, most_fields> widths;
    widths.fill(format_ == DynaFormat::long_fields ? 20 : format_ == DynaFormat::ten_columns ? 10 : width);
    split(widths.data(), count);
    return fields_;
}

const std::vector<std::string_view>& DynaCards::node_fields()
{
    const std::size_t number = format_ == DynaFormat::long_fields ? 20 : format_ == DynaFormat::ten_columns ? 10 : 8;
    const std::size_t place = format_ == DynaFormat::long_fields ? 20 : 16;
    const std::array<std::size_t, 4> widths{number, place, place, place};
    split(widths.data(), widths.size());
    return fields_;
}

void DynaCards::split(const std::size_t* widths, std::size_t count)
{
    std::string_view line = lines_.text();
    if (line.find(',') != std::string_view::npos) {
        fields_ = comma_fields(line);
    } else if (trimmed_field(line).find('\t') != std::string_view::npos) {
        fields_ = fields_between_blanks(line);
    } else {
        fields_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            fields_.push_back(trimmed_field(line.substr(0, widths[i])));
            line.remove_prefix(std::min(widths[i], line.size()));
        }
    }
    if (lines_.text().find_first_of("&<") == std::string_view::npos) return;
    replaced_.clear();
    replaced_.reserve(fields_.size());
    for (std::string_view& field : fields_) field = with_parameters(field);
}

std::string_view DynaCards::with_parameters(std::string_view field)
{
    if (field.starts_with('<') && field.ends_with('>'))
        return replaced_.emplace_back(written(evaluated(field.substr(1, field.size() - 2))));
    const bool minus = field.starts_with("-&");
    if (!minus && !field.starts_with('&')) return field;
    const std::string name = in_capitals(trimmed_field(field.substr(minus ? 2 : 1)));
    const Parameter& found = parameter(name);
    if (found.is_text && !minus) return replaced_.emplace_back(found.text);
    DeckNumber number = number_of(name);
    if (minus) number.value = -number.value;
    return replaced_.emplace_back(written(number));
}

const DynaCards::Parameter& DynaCards::parameter(const std::string& name) const
{
    const auto found = parameters_.find(name);
    if (found != parameters_.end())
        for (auto one = found->second.rbegin(); one != found->second.rend(); ++one)
            if (!one->local || lines_.within(one->file)) return *one;
    lines_.fail(fmt::format("there is no parameter '{}'", shown_field(name)), "give it with *PARAMETER before it is used");
}

DeckNumber DynaCards::number_of(const std::string& name) const
{
    const Parameter& found = parameter(name);
    if (found.is_text) lines_.fail(fmt::format("the parameter '{}' is a text, not a number", name), "correct the line");
    return found.number;
}

DeckNumber DynaCards::evaluated(std::string_view expression) const
{
    return evaluate_expression(lines_, expression, [this](const std::string& name) { return number_of(name); });
}

void DynaCards::begin_parameters(const std::string& options)
{
    for (std::string left = options; !left.empty();) {
        const std::size_t next = std::min(left.find('_', 1), left.size());
        const std::string option = left.substr(0, next);
        if (option != "_EXPRESSION" && option != "_LOCAL" && option != "_MUTABLE")
            lines_.fail(fmt::format("*PARAMETER{} is not read", options), "use *PARAMETER or *PARAMETER_EXPRESSION");
        left.erase(0, next);
    }
    parameter_options_ = options;
}

void DynaCards::read_parameters()
{
    if (parameter_options_.find("_EXPRESSION") != std::string::npos) return read_expression();
    const std::vector<std::string_view> card = fields(8, 10);
    for (std::size_t i = 0; i < card.size(); i += 2)
        if (!card[i].empty()) define(card[i], i + 1 < card.size() ? card[i + 1] : std::string_view{}, false);
}

void DynaCards::read_expression()
{
    const std::size_t width = format_ == DynaFormat::long_fields ? 20 : 10;
    std::string text(lines_.text());
    const std::size_t comma = text.find(',');
    const bool by_comma = comma != std::string::npos && comma < width;
    const std::string name(trimmed_field(std::string_view(text).substr(0, by_comma ? comma : width)));
    std::string expression = text.size() > (by_comma ? comma : width) ? text.substr(by_comma ? comma + 1 : width) : "";
    const DeckPlace place = lines_.place();
    for (auto more = lines_.following(); !by_comma && more; more = lines_.following()) {
        if (!more->starts_with('$') && !is_blank_line(more->substr(0, width))) break;
        lines_.next();
        if (!more->starts_with('$')) expression += " " + std::string(more->substr(std::min(width, more->size())));
    }
    if (name.empty()) lines_.fail_at(place, "the name of a parameter is missing", "write R or I and its name in the first ten columns");
    define(name, expression, true);
}

/// Takes up a parameter from its name, with the kind before it, and its value. One that is given again must be as it was.
void DynaCards::define(std::string_view named, std::string_view value, bool expression)
{
    const std::string capitals = in_capitals(named);
    const std::string name(trimmed_field(std::string_view(capitals).substr(1)));
    const char kind = capitals[0];
    if (name.empty() || (kind != 'R' && kind != 'I' && kind != 'C'))
        lines_.fail(fmt::format("'{}' is not the name of a parameter", shown_field(named)),
                    "write R (real), I (integer) or C (characters) before the name");
    Parameter fresh;
    fresh.file = lines_.place().file;
    fresh.local = parameter_options_.find("_LOCAL") != std::string::npos;
    fresh.may_change = parameter_options_.find("_MUTABLE") != std::string::npos;
    fresh.is_text = kind == 'C';
    if (fresh.is_text)
        fresh.text = trimmed_field(value);
    else
        fresh.number = expression ? evaluated(value) : DeckNumber{real_field(lines_, value, "the value of a parameter"), false};
    if (kind == 'I') fresh.number = {std::trunc(fresh.number.value), true};
    if (kind == 'R') fresh.number.whole = false;
    auto& all = parameters_[name];
    for (Parameter& before : all) {
        if (before.local != fresh.local || (fresh.local && before.file != fresh.file)) continue;
        const bool same = before.number.value == fresh.number.value && before.text == fresh.text && before.is_text == fresh.is_text;
        if (!same && !before.may_change)
            lines_.fail(fmt::format("the parameter '{}' is given a second time, with another value", shown_field(name)),
                        "give each parameter once, or with *PARAMETER_MUTABLE");
        fresh.may_change = fresh.may_change || before.may_change;
        before = fresh;
        return;
    }
    fresh.local ? void(all.push_back(fresh)) : void(all.insert(all.begin(), fresh));
}

std::string DynaCards::file_name()
{
    std::string name(trimmed_field(lines_.text()));
    while (name.ends_with(" +")) {
        next_of_keyword("the rest of a file's name");
        name = name.substr(0, name.size() - 2) + std::string(trimmed_field(lines_.text()));
    }
    return std::string(with_parameters(name));
}

void DynaCards::include_list(const std::vector<std::string>& folders)
{
    std::vector<std::string> names{file_name()};
    while (next_in_keyword())
        if (!is_blank_line(text())) names.push_back(file_name());
    for (auto name = names.rbegin(); name != names.rend(); ++name) include(*name, file(), folders);
}

void DynaCards::include(const std::string& name, const DynaFile& as, const std::vector<std::string>& folders)
{
    const DynaFile own = as;
    const std::uint32_t index = lines_.include(name, folders);
    files_.resize(index + 1);
    files_[index] = own;
}

}  // namespace corpuscle
