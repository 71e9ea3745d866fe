#include "input/meshes/deck_lines.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::size_t deepest = 20;  // files that include one another

/// A number as C++ reads it, of one as Fortran writes it: an exponent with D, or without a letter.
std::string plain_real(std::string_view field)
{
    std::string text(field.starts_with('+') ? field.substr(1) : field);
    for (char& c : text)
        if (c == 'd' || c == 'D') c = 'e';
    const std::size_t sign = text.find_first_of("+-", 1);
    if (sign != std::string::npos && text[sign - 1] != 'e' && text[sign - 1] != 'E') text.insert(sign, "e");
    const std::size_t plus = text.find("e+");
    return plus == std::string::npos ? text : text.erase(plus + 1, 1);
}

/// What would mend a field that is no number.
const char* number_remedy(std::string_view field)
{
    if (field.find_first_of(" \t") != std::string_view::npos) return "put commas between the fields, or each into its columns";
    return "correct the line, or export the mesh again";
}

/// The file of that name: as it is if it is a full path, else beside the deck or in the first folder that has it. Folders may be parted
/// as on Windows.
std::filesystem::path found_file(std::string name, const std::filesystem::path& beside, const std::vector<std::string>& folders)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path first = beside / name;
    if (std::filesystem::is_regular_file(first)) return first;
    for (const std::string& folder : folders)
        if (const std::filesystem::path file = std::filesystem::path(folder) / name; std::filesystem::is_regular_file(file)) return file;
    return first;
}

}  // namespace

DeckLines::DeckLines(Scanner deck) : files_{deck.file()}
{
    open_.push_back({std::move(deck), {0, 0}, 0});
}

bool DeckLines::next()
{
    while (!open_.empty() && open_.back().scanner.rest().empty()) open_.pop_back();
    if (open_.empty()) return false;
    text_ = open_.back().scanner.line();
    ++open_.back().place.line;
    place_ = open_.back().place;
    return true;
}

std::optional<std::string_view> DeckLines::following() const
{
    const std::string_view rest = open_.empty() ? std::string_view{} : open_.back().scanner.rest();
    if (rest.empty()) return std::nullopt;
    return rest.substr(0, rest.find_first_of("\r\n"));
}

std::uint32_t DeckLines::include(const std::string& name, const std::vector<std::string>& folders)
{
    if (name.find('\0') != std::string::npos) fail("the name of a file has a byte 0", "correct the line");
    const std::filesystem::path path = found_file(name, folder(), folders);
    const std::string file = path.lexically_normal().string();
    const auto owner = std::find_if(open_.rbegin(), open_.rend(), [&](const Open& open) { return open.place.file == place_.file; });
    const std::size_t depth = owner == open_.rend() ? 0 : owner->depth + 1;
    if (any_around([&](std::uint32_t around) { return files_[around] == file; }))
        fail(fmt::format("'{}' includes itself", name), "take the line out");
    if (depth >= deepest) fail(fmt::format("{} files include one another", depth), "include the files in one deck");
    if (!std::filesystem::is_regular_file(path))
        fail(fmt::format("there is no file '{}' to include", file), "give its name as seen from this file, or its full path");
    files_.push_back(file);
    const auto index = static_cast<std::uint32_t>(files_.size() - 1);
    open_.push_back({Scanner::open(file), {index, 0}, depth});
    return index;
}

bool DeckLines::within(std::uint32_t file) const
{
    return any_around([&](std::uint32_t around) { return around == file; });
}

std::string DeckLines::folder() const
{
    return std::filesystem::path(files_[place_.file]).parent_path().string();
}

void DeckLines::fail_at(const DeckPlace& place, const std::string& problem, const std::string& remedy) const
{
    throw InputError(problem, remedy, {files_[place.file], static_cast<int>(place.line), 1});
}

std::string shown_field(std::string_view field)
{
    std::string text(field.substr(0, 40));
    std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

std::string_view trimmed_field(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_capitals(std::string_view text)
{
    std::string capitals(text);
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return capitals;
}

std::vector<std::string_view> comma_fields(std::string_view line)
{
    std::vector<std::string_view> fields;
    line = trimmed_field(line);
    while (!line.empty()) {
        const std::size_t comma = std::min(line.find(','), line.size());
        fields.push_back(trimmed_field(line.substr(0, comma)));
        line.remove_prefix(std::min(comma + 1, line.size()));
    }
    return fields;
}

double real_field(const DeckLines& lines, std::string_view field, const char* what)
{
    if (field.empty()) return 0.0;
    const std::string text = plain_real(field);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        lines.fail(fmt::format("'{}' is not a number ({} was expected)", shown_field(field), what), number_remedy(field));
    return value;
}

std::int64_t integer_field(const DeckLines& lines, std::string_view field, const char* what)
{
    if (field.empty()) return 0;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size())
        lines.fail(fmt::format("'{}' is not a whole number ({} was expected)", shown_field(field), what), number_remedy(field));
    return value;
}

}  // namespace corpuscle
