#pragma once

#include <utility>

#include "base/error.hpp"

namespace corpuscle {

/// Does `work`; an InputError without a place gets the place of what was being built.
template <class Work>
auto at_place(const Place& place, Work&& work) -> decltype(work())
{
    try {
        return std::forward<Work>(work)();
    } catch (const InputError& error) {
        if (error.place().known()) throw;
        throw InputError(error.problem(), error.remedy(), place);
    }
}

}  // namespace corpuscle
