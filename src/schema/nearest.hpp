#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace corpuscle {

/// Letters to insert, delete, replace or swap with their neighbour to make one word of the other (optimal string alignment).
[[nodiscard]] std::size_t edit_distance(const std::string& a, const std::string& b);

/// The names most like `word`, best first, at most `most`; none that shares too little with it. Case does not count.
[[nodiscard]] std::vector<std::string> nearest_names(const std::string& word, const std::vector<std::string>& names, std::size_t most = 3);

/// What to say about a word that is not among the names: "did you mean 'x'?", else the names there are.
[[nodiscard]] std::string suggestion(const std::string& word, const std::vector<std::string>& names);

/// "a, b, c": the first `most` names, then how many more there are.
[[nodiscard]] std::string listed(const std::vector<std::string>& names, std::size_t most = 24);

}  // namespace corpuscle
