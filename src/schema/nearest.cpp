#include "schema/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace corpuscle {

namespace {

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// How unlike two words are, in half letters; a name that begins with the word is nearest, one that contains it near.
std::size_t unlikeness(const std::string& word, const std::string& name)
{
    const std::size_t distance = 2 * edit_distance(word, name);
    if (word.size() < 3) return distance;
    const std::size_t at = name.find(word);
    if (at == 0) return std::min<std::size_t>(distance, 1);
    return at != std::string::npos ? std::min<std::size_t>(distance, 3) : distance;
}

}  // namespace

std::size_t edit_distance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::vector<std::string> nearest_names(const std::string& word, const std::vector<std::string>& names, std::size_t most)
{
    struct Candidate {
        std::size_t distance;
        std::size_t place;  // among the names: of equals the first
        std::string name;
    };
    const std::string wanted = lower_case(word);
    const std::size_t limit = 2 * std::max<std::size_t>(1, (wanted.size() + 1) / 3);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t distance = unlikeness(wanted, lower_case(names[i]));
        if (distance <= limit) candidates.push_back({distance, i, names[i]});
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return std::pair(a.distance, a.place) < std::pair(b.distance, b.place); });
    std::vector<std::string> best;
    for (const Candidate& candidate : candidates) {
        if (best.size() == most) break;
        if (std::find(best.begin(), best.end(), candidate.name) == best.end()) best.push_back(candidate.name);
    }
    return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names)
{
    std::vector<std::string> near = nearest_names(word, names);
    if (near.empty()) return names.empty() ? std::string() : "known: " + listed(names);
    for (std::string& name : near) name = "'" + name + "'";
    return fmt::format("did you mean {}?", fmt::join(near, " or "));
}

std::string listed(const std::vector<std::string>& names, std::size_t most)
{
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(most), ", "),
                       names.size() - most);
}

}  // namespace corpuscle
