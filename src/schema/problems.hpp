#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace corpuscle {

/// Several things wrong with one input, found in one reading; what() tells them all, a line each.
class InputProblems : public InputError {
public:
    explicit InputProblems(std::vector<InputError> all);

    [[nodiscard]] const std::vector<InputError>& all() const { return all_; }

private:
    std::vector<InputError> all_;
};

/// Gathers what is wrong while reading goes on, so that a user mends all of it at once.
class Problems {
public:
    void add(std::string problem, std::string remedy, Place place);
    void add(const InputError& error) { found_.push_back(error); }
    [[nodiscard]] bool none() const { return found_.empty(); }
    [[nodiscard]] const std::vector<InputError>& found() const { return found_; }
    /// Throws what was found, in the order of the places: one InputError, or InputProblems. Does nothing if there is none.
    void raise() const;

private:
    std::vector<InputError> found_;
};

}  // namespace corpuscle
