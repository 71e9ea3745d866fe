#include "schema/problems.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace corpuscle {

namespace {

std::string joined(const std::vector<InputError>& all)
{
    std::string text;
    for (const InputError& error : all) text += (text.empty() ? "" : "\n") + std::string(error.what());
    return text;
}

}  // namespace

InputProblems::InputProblems(std::vector<InputError> all) : InputError(joined(all)), all_(std::move(all)) {}

void Problems::add(std::string problem, std::string remedy, Place place)
{
    found_.emplace_back(std::move(problem), std::move(remedy), std::move(place));
}

void Problems::raise() const
{
    if (found_.empty()) return;
    std::vector<std::size_t> order(found_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(found_[a].place().line, a) < std::pair(found_[b].place().line, b); });
    std::vector<InputError> ordered;
    for (const std::size_t i : order) ordered.push_back(found_[i]);
    if (ordered.size() == 1) throw ordered.front();
    throw InputProblems(std::move(ordered));
}

}  // namespace corpuscle
