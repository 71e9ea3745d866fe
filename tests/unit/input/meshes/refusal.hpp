#pragma once

#include <string>

#include "base/error.hpp"

namespace corpuscle {

/// What read() is refused with.
template <class Read>
std::string refusal_of(const Read& read)
{
    try {
        static_cast<void>(read());
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace corpuscle
