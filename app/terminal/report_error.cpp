#include "app/terminal/report_error.hpp"

#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "schema/problems.hpp"

namespace corpuscle {

namespace {

void report_one(const Error& error)
{
    fmt::print(stderr, "{}{}\n{}", error.place().known() ? "" : "corpuscle: ", error.what(), quoted_source(error.place()));
}

/// Blanks as wide as the first `columns` letters of the line, tabs kept.
std::string blanks_under(const std::string& line, int columns)
{
    std::string blanks;
    int letters = 0;
    for (const char c : line) {
        const bool begins_letter = (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
        if (begins_letter && letters++ == columns) break;
        if (begins_letter) blanks += c == '\t' ? '\t' : ' ';
    }
    return blanks;
}

}  // namespace

std::string quoted_source(const Place& place)
{
    if (place.line <= 0) return "";
    std::ifstream file(place.file);
    std::string line;
    for (int number = 0; number < place.line; ++number)
        if (!std::getline(file, line)) return "";
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return fmt::format("    {}\n    {}^\n", line, blanks_under(line, place.column - 1));
}

void report_error(const Error& error)
{
    std::fflush(stdout);
    if (const auto* several = dynamic_cast<const InputProblems*>(&error)) {
        for (const InputError& one : several->all()) report_one(one);
        fmt::print(stderr, "{} mistakes\n", several->all().size());
    } else {
        report_one(error);
    }
    std::fflush(stderr);
}

}  // namespace corpuscle
