#pragma once

#include <stdexcept>
#include <string>

namespace corpuscle {

/// Where a value was read: empty file for values that no file gave.
struct Place {
    std::string file;
    int line = 0;
    int column = 0;

    [[nodiscard]] bool known() const { return !file.empty(); }
};

/// The one error of the library: what is wrong, where it was read, and what would mend it.
class Error : public std::runtime_error {
public:
    explicit Error(std::string problem, std::string remedy = "", Place place = {});

    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] const std::string& remedy() const { return remedy_; }
    [[nodiscard]] const Place& place() const { return place_; }

private:
    std::string problem_;
    std::string remedy_;
    Place place_;
};

/// Wrong input: the command line answers with exit code 2.
class InputError : public Error {
    using Error::Error;
};

/// A run stopped by its own safety (NaN, lost energy, lost particle): exit code 3.
class SafetyStop : public Error {
    using Error::Error;
};

}  // namespace corpuscle
