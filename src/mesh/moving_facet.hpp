#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/vector3.hpp"
#include "mesh/cubic.hpp"

namespace corpuscle {

/// A facet whose corners go straight from start to end while a point goes straight, too: corners as seen from the point [m].
/// The side function s(t) = -det(a, b, c)(t) (positive where the normal (b-a)x(c-a) points) is a cubic in t, 0 <= t <= 1.
struct MovingFacet {
    std::array<Vector3d, 3> start, end;

    /// A meeting of point and facet.
    struct Meeting {
        double fraction = 2;             ///< of the path; above 1: none
        std::array<double, 3> weight{};  ///< of the corners at the point met
        Vector3d normal;                 ///< unit normal there, towards the side the point comes from
        bool upper = false;              ///< which is the side of the facet's own normal
    };

    /// The first meeting after fraction 0; if `leaving`, the point starts on the facet and only a later meeting counts.
    [[nodiscard]] Meeting first_meeting(bool leaving) const;

private:
    [[nodiscard]] Vector3d corner(int i, double t) const { return start[i] + t * (end[i] - start[i]); }
    [[nodiscard]] std::array<double, 4> side_function(bool leaving) const;
    [[nodiscard]] double noise() const;
    [[nodiscard]] Meeting meeting_at(double t, double from_side, double uncertainty) const;
};

/// Largest rounding error that the side function can have: a bound on that of three products of three differences each.
inline double MovingFacet::noise() const
{
    double bound = 1e-14;
    for (int i = 0; i < 3; ++i) {
        const Vector3d &p = start[i], &q = end[i];
        bound *= std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    }
    return bound;
}

/// Bernstein coefficients of s(t), by the polar form of the determinant; the first is 0 by decree if the point starts on the facet.
inline std::array<double, 4> MovingFacet::side_function(bool leaving) const
{
    const Vector3d first = cross(start[1], start[2]), last = cross(end[1], end[2]);
    const Vector3d mixed = cross(start[1], end[2]) + cross(end[1], start[2]);
    return {leaving ? 0.0 : -dot(start[0], first), -(dot(end[0], first) + dot(start[0], mixed)) / 3,
            -(dot(start[0], last) + dot(end[0], mixed)) / 3, -dot(end[0], last)};
}

/// The meeting at time t, when the point is in the facet's plane, if it is in the facet: edges reach over by 1e-9 of their
/// length, and by as much as the point may be elsewhere because t is only so certain.
inline MovingFacet::Meeting MovingFacet::meeting_at(double t, double from_side, double uncertainty) const
{
    const Vector3d a = corner(0, t), b = corner(1, t), c = corner(2, t);
    const Vector3d area = cross(b - a, c - a);
    const double square = norm_squared(area);
    const double longest = std::max({norm_squared(b - a), norm_squared(c - a), norm_squared(c - b)});
    if (!(square > 1e-24 * longest * longest)) return {};
    const std::array<double, 3> weight{dot(area, cross(b, c)) / square, dot(area, cross(c, a)) / square, dot(area, cross(a, b)) / square};
    const double drift = norm(end[0] - start[0]) + norm(end[1] - start[1]) + norm(end[2] - start[2]);
    const double tolerance = 1e-9 + std::min(1e-6, uncertainty * drift * std::sqrt(longest / square));
    if (std::min({weight[0], weight[1], weight[2]}) < -tolerance) return {};
    Meeting meeting{t, {std::max(0.0, weight[0]), std::max(0.0, weight[1]), std::max(0.0, weight[2])}, {}, false};
    const double total = meeting.weight[0] + meeting.weight[1] + meeting.weight[2];
    for (double& w : meeting.weight) w /= total;
    meeting.upper = !(from_side < 0);
    meeting.normal = area * ((meeting.upper ? 1 : -1) / std::sqrt(square));
    return meeting;
}

inline MovingFacet::Meeting MovingFacet::first_meeting(bool leaving) const
{
    const double band = noise();
    const std::array<double, 4> s = side_function(leaving);
    if (s[0] > band && s[1] > band && s[2] > band && s[3] > band) return {};
    if (s[0] < -band && s[1] < -band && s[2] < -band && s[3] < -band) return {};
    const Cubic cubic(s);
    const CubicRoots roots = leaving ? cubic.roots_after_zero() : cubic.roots();
    for (int r = 0; r < roots.count; ++r) {
        const double slope = std::abs(cubic.slope(roots.at[r]));
        const Meeting meeting = meeting_at(roots.at[r], roots.before[r], slope > 0 ? std::min(1.0, band / slope) : 1.0);
        if (meeting.fraction <= 1) return meeting;
    }
    if (std::abs(s[3]) > band) return {};
    const double side = roots.count > 0 ? -roots.before[roots.count - 1] : leaving ? s[1] : s[0];  // the path ends on the facet
    return meeting_at(1, side, 0);
}

}  // namespace corpuscle
