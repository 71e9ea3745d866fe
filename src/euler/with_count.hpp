#pragma once

#include <cstddef>
#include <type_traits>

namespace corpuscle {

/// Calls what(std::integral_constant<M>) for the number of materials in sight.
template <class What>
auto with_count(std::size_t count, const What& what)
{
    switch (count) {
        case 1: return what(std::integral_constant<std::size_t, 1>{});
        case 2: return what(std::integral_constant<std::size_t, 2>{});
        case 3: return what(std::integral_constant<std::size_t, 3>{});
        default: return what(std::integral_constant<std::size_t, 4>{});
    }
}

}  // namespace corpuscle
