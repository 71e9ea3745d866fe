#include "input/meshes/scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // that editors put before text
constexpr const char* export_again = "the file may be cut short or damaged: export it again";

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

/// The word as an error shows it: short, without control characters.
std::string shown(std::string_view word)
{
    std::string text(word.substr(0, 40));
    std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

}  // namespace

Scanner Scanner::open(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    if (stream) content << stream.rdbuf();
    if (!stream || content.str().empty())
        throw InputError("the mesh file cannot be read or is empty", "check its name and that it may be read", {file, 0, 0});
    std::string text = std::move(content).str();
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    return {file, std::move(text)};
}

void Scanner::skip_blanks()
{
    while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
}

std::string_view Scanner::line()
{
    const std::string_view left = rest();
    last_ = position_;
    const std::size_t end = std::min(left.find('\n'), left.size());
    position_ = std::min(position_ + end + 1, text_.size());
    std::string_view line = left.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string_view Scanner::word_on_line()
{
    while (position_ < text_.size() && is_blank(text_[position_]) && text_[position_] != '\n') ++position_;
    const std::size_t begin = last_ = position_;
    while (position_ < text_.size() && !is_blank(text_[position_])) ++position_;
    return std::string_view(text_).substr(begin, position_ - begin);
}

std::string_view Scanner::word(const char* what)
{
    skip_blanks();
    const std::string_view word = word_on_line();
    if (word.empty()) fail(fmt::format("the file ends where {} was expected", what), export_again);
    return word;
}

double Scanner::real(const char* what)
{
    std::string_view text = word(what);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        fail(fmt::format("'{}' is not a number ({} was expected)", shown(text), what), export_again);
    return value;
}

std::int64_t Scanner::integer(const char* what)
{
    const std::string_view text = word(what);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        fail(fmt::format("'{}' is not a whole number ({} was expected)", shown(text), what), export_again);
    return value;
}

bool Scanner::at_end()
{
    skip_blanks();
    return position_ == text_.size();
}

void Scanner::skip_past_line(std::string_view mark)
{
    const std::string begins_line = "\n" + std::string(mark);
    last_ = position_;
    const std::size_t found = rest().starts_with(mark) ? position_ : text_.find(begins_line, position_);
    if (found == std::string::npos) fail(fmt::format("'{}' is missing", mark), export_again);
    position_ = found + (text_[found] == '\n' ? 1 : 0);
    line();
}

template <class T>
T Scanner::bytes(const char* what)
{
    last_ = position_;
    if (text_.size() - position_ < sizeof(T)) fail(fmt::format("the file ends where {} was expected", what), export_again);
    T value;
    std::memcpy(&value, text_.data() + position_, sizeof(T));
    position_ += sizeof(T);
    return value;
}

template int Scanner::bytes<int>(const char*);
template std::uint32_t Scanner::bytes<std::uint32_t>(const char*);
template std::uint16_t Scanner::bytes<std::uint16_t>(const char*);
template std::uint64_t Scanner::bytes<std::uint64_t>(const char*);
template double Scanner::bytes<double>(const char*);
template float Scanner::bytes<float>(const char*);
template std::byte Scanner::bytes<std::byte>(const char*);

std::size_t Scanner::count(std::int64_t records, std::size_t least_bytes, const char* what)
{
    const std::size_t left = text_.size() - position_;
    if (records < 0 || static_cast<std::uint64_t>(records) > left / least_bytes + 1)
        fail(fmt::format("{} {} are announced, but only {} bytes are left", records, what, left), export_again);
    return static_cast<std::size_t>(records);
}

void Scanner::fail(const std::string& problem, const std::string& remedy) const
{
    const std::size_t at = std::min(last_, text_.size());
    if (binary_) throw InputError(fmt::format("at byte {}: {}", at, problem), remedy, {file_, 0, 0});
    const auto here = text_.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line_number = 1 + std::count(text_.begin(), here, '\n');
    const std::size_t line_start = at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    throw InputError(problem, remedy, {file_, static_cast<int>(line_number), static_cast<int>(at - line_start + 1)});
}

}  // namespace corpuscle
