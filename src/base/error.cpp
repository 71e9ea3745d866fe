#include "base/error.hpp"

#include <fmt/format.h>

namespace corpuscle {

namespace {

/// "file:line:column: problem; remedy", leaving out what is not known.
std::string compose(const std::string& problem, const std::string& remedy, const Place& place)
{
    std::string text;
    if (place.known()) {
        text = place.line > 0 ? fmt::format("{}:{}:{}: ", place.file, place.line, place.column) : place.file + ": ";
    }
    text += problem;
    if (!remedy.empty()) text += "; " + remedy;
    return text;
}

}  // namespace

Error::Error(std::string problem, std::string remedy, Place place)
    : std::runtime_error(compose(problem, remedy, place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)),
      place_(std::move(place))
{
}

}  // namespace corpuscle
