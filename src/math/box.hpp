#pragma once

#include <algorithm>
#include <limits>

#include "math/vector3.hpp"

namespace corpuscle {

/// An axis-parallel box; empty (lower above upper) until something is put in.
struct Box {
    Vector3d lower{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Vector3d upper{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    [[nodiscard]] Vector3d size() const { return upper - lower; }
    [[nodiscard]] Vector3d center() const { return 0.5 * (lower + upper); }
    [[nodiscard]] double volume() const { return size().x * size().y * size().z; }
    [[nodiscard]] bool contains(const Vector3d& p) const
    {
        return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y && p.z >= lower.z && p.z <= upper.z;
    }
    [[nodiscard]] bool overlaps(const Box& b) const
    {
        return lower.x <= b.upper.x && b.lower.x <= upper.x && lower.y <= b.upper.y && b.lower.y <= upper.y && lower.z <= b.upper.z &&
               b.lower.z <= upper.z;
    }
    void include(const Vector3d& p)
    {
        for (int a = 0; a < 3; ++a) {
            lower[a] = std::min(lower[a], p[a]);
            upper[a] = std::max(upper[a], p[a]);
        }
    }
    void grow(double margin)
    {
        lower -= {margin, margin, margin};
        upper += {margin, margin, margin};
    }
};

}  // namespace corpuscle
