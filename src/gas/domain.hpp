#pragma once

#include <array>

#include "math/box.hpp"
#include "math/vector3.hpp"

namespace corpuscle {

/// What an edge of the gas box does to a particle that reaches it.
enum class Edge {
    rigid,    ///< specular wall; also a plane of symmetry
    open,     ///< the particle leaves for good
    ambient,  ///< the particle leaves; ambient gas flows in
};

/// What gas has given to an edge of the domain (impulse of bounces, or what has left), less what it got there.
struct Passage {
    double mass = 0;    ///< [kg]
    Vector3d momentum;  ///< [kg m/s]
    double energy = 0;  ///< [J]

    Passage& operator+=(const Passage& other)
    {
        mass += other.mass;
        momentum += other.momentum;
        energy += other.energy;
        return *this;
    }
};

/// Faces are numbered x-, x+, y-, y+, z-, z+.
inline constexpr int face_count = 6;

struct FacePassages {
    std::array<Passage, face_count> face{};
    std::array<double, face_count> squares{};  ///< sum of the squared impulses of bounces, for the noise of their sum [N2 s2]

    FacePassages& operator+=(const FacePassages& other)
    {
        for (int f = 0; f < face_count; ++f) {
            face[f] += other.face[f];
            squares[f] += other.squares[f];
        }
        return *this;
    }
};

/// The box that holds the gas and what its six faces are.
struct Domain {
    Box box;                               ///< [m]
    std::array<Edge, face_count> edges{};  ///< x-, x+, y-, y+, z-, z+

    /// The first face that the straight path from `start` to `end` leaves through, and the fraction of the path to it
    /// (0 if `start` is outside already); face -1 if `end` is inside.
    struct Exit {
        int face = -1;
        double fraction = 1;
    };
    [[nodiscard]] Exit first_exit(const Vector3d& start, const Vector3d& end) const
    {
        Exit exit;
        for (int axis = 0; axis < 3; ++axis) {
            const double travel = end[axis] - start[axis];
            const bool below = end[axis] < box.lower[axis];
            if (!below && !(end[axis] > box.upper[axis])) continue;
            const double wall = below ? box.lower[axis] : box.upper[axis];
            const double fraction = travel == 0 ? 0.0 : std::clamp((wall - start[axis]) / travel, 0.0, 1.0);
            if (exit.face < 0 || fraction < exit.fraction) exit = {2 * axis + (below ? 0 : 1), fraction};
        }
        return exit;
    }
};

}  // namespace corpuscle
