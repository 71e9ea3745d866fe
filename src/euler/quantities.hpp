#pragma once

#include <cstddef>

namespace corpuscle {

/// Numbers of the quantities of a cell that holds `M` materials, in a tile and in rows of face states. The first ones, up to `advected`,
/// are reconstructed by slopes.
template <std::size_t M>
struct Primitive {
    static constexpr std::size_t density(std::size_t m) { return m; }                             ///< of a material in its own part [kg/m3]
    static constexpr std::size_t cold(std::size_t m) { return M + m; }                            ///< Q of its law [Pa]
    static constexpr std::size_t velocity(int d) { return 2 * M + static_cast<std::size_t>(d); }  ///< [m/s]
    static constexpr std::size_t pressure = 2 * M + 3;                                            ///< [Pa]
    static constexpr std::size_t advected = 2 * M + 4;
    static constexpr std::size_t stiff(std::size_t m) { return advected + m; }      ///< Z of its law [Pa]
    static constexpr std::size_t share(std::size_t m) { return advected + M + m; }  ///< of the volume [1]
    static constexpr std::size_t count = advected + 2 * M;
};

/// Numbers of the conserved quantities and the shares, in the same way.
template <std::size_t M>
struct Conserved {
    static constexpr std::size_t mass(std::size_t m) { return m; }
    static constexpr std::size_t motion(int d) { return M + static_cast<std::size_t>(d); }
    static constexpr std::size_t energy = M + 3;
    static constexpr std::size_t share(std::size_t m) { return M + 4 + m; }
    static constexpr std::size_t part(std::size_t m) { return 2 * M + 4 + m; }  ///< internal energy of a material; not stored [J/m3]
    static constexpr std::size_t count = 3 * M + 4;
};

}  // namespace corpuscle
