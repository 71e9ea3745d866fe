#include "schema/problems.hpp"

#include <algorithm>

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
    std::vector<InputError> ordered = found_;
    std::stable_sort(ordered.begin(), ordered.end(), [](const InputError& a, const InputError& b) { return a.place().line < b.place().line; });
    if (ordered.size() == 1) throw ordered.front();
    throw InputProblems(std::move(ordered));
}

}  // namespace corpuscle
