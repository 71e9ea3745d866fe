#include "mesh/revolved.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace corpuscle {

namespace {

/// Signed area of the circle's sector from the direction of a to that of b.
double sector_area(const Vector3d& a, const Vector3d& b, double radius)
{
    return 0.5 * radius * radius * std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// Signed area of the triangle (0, a, b) within the circle: sectors where the edge runs outside, a triangle where it runs inside.
double circle_edge_area(const Vector3d& a, const Vector3d& b, double radius)
{
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    if (length2 == 0.0) return 0.0;
    const double middle = -(a.x * dx + a.y * dy) / length2;  // where the edge's line is nearest to the center
    const double distance = (a.x * dy - a.y * dx) / std::sqrt(length2);
    const double half2 = (radius * radius - distance * distance) / length2;
    if (half2 <= 0.0) return sector_area(a, b, radius);
    const double half = std::sqrt(half2);
    const double enter = std::clamp(middle - half, 0.0, 1.0), leave = std::clamp(middle + half, 0.0, 1.0);
    if (enter >= leave) return sector_area(a, b, radius);
    const Vector3d in{a.x + enter * dx, a.y + enter * dy, 0.0}, out{a.x + leave * dx, a.y + leave * dy, 0.0};
    const double inside = 0.5 * (in.x * out.y - in.y * out.x);
    return (enter > 0.0 ? sector_area(a, in, radius) : 0.0) + inside + (leave < 1.0 ? sector_area(out, b, radius) : 0.0);
}

/// The box seen from the body: corners relative to its center, two directions normal to its axis.
class Slicer {
public:
    Slicer(const Box& box, const Revolved& body) : body_(body)
    {
        int least = 0;
        for (int a = 1; a < 3; ++a)
            if (std::abs(body.axis[a]) < std::abs(body.axis[least])) least = a;
        Vector3d helper;
        helper[least] = 1.0;
        first_ = normalized(cross(body.axis, helper));
        second_ = cross(body.axis, first_);
        for (int i = 0; i < 8; ++i) {
            const Vector3d corner{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z};
            const Vector3d arm = corner - body.center;
            corners_[i] = {dot(arm, first_), dot(arm, second_), dot(arm, body.axis)};
        }
    }

    /// Values of s between which the slice of the box changes smoothly.
    [[nodiscard]] std::vector<double> breaks() const
    {
        std::vector<double> s{body_.lower, body_.upper};
        for (const Vector3d& corner : corners_)
            if (corner.z > body_.lower && corner.z < body_.upper) s.push_back(corner.z);
        std::sort(s.begin(), s.end());
        return s;
    }

    /// Area that the box and the body share in the plane at s.
    [[nodiscard]] double area(double s) const
    {
        std::array<Vector3d, 12> polygon;
        int count = 0;
        for (int from = 0; from < 8; ++from)
            for (const int bit : {1, 2, 4}) {
                const Vector3d &a = corners_[from], &b = corners_[from | bit];
                if ((from & bit) == 0 && (a.z > s) != (b.z > s)) polygon[count++] = a + ((s - a.z) / (b.z - a.z)) * (b - a);
            }
        if (count < 3) return 0.0;
        order(polygon, count);
        return circle_polygon_area(polygon.data(), count, body_.radius(s));
    }

private:
    /// Sorts the corners of a convex polygon counter-clockwise about their mean.
    static void order(std::array<Vector3d, 12>& polygon, int count)
    {
        Vector3d mean;
        for (int i = 0; i < count; ++i) mean += polygon[i] / count;
        std::array<std::pair<double, Vector3d>, 12> sorted;
        for (int i = 0; i < count; ++i) sorted[i] = {std::atan2(polygon[i].y - mean.y, polygon[i].x - mean.x), polygon[i]};
        std::sort(sorted.begin(), sorted.begin() + count, [](const auto& a, const auto& b) { return a.first < b.first; });
        for (int i = 0; i < count; ++i) polygon[i] = sorted[i].second;
    }

    const Revolved& body_;
    Vector3d first_, second_;
    std::array<Vector3d, 8> corners_;  ///< in (first, second, axis) [m]
};

struct Estimate {
    double value;
    double error;
};

/// 15-point Kronrod and 7-point Gauss sums (Piessens et al., QUADPACK 1983).
Estimate gauss_kronrod(const Slicer& slicer, double from, double to)
{
    static constexpr std::array<double, 8> node{0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                                0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                                0.586087235467691130294144691693240, 0.405845151377397166906606412076961,
                                                0.207784955007898467600689403773245, 0.0};
    static constexpr std::array<double, 8> kronrod{0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                                   0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                                   0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                                   0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
    static constexpr std::array<double, 4> gauss{0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                                 0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double fine = 0.0, coarse = 0.0;
    for (int i = 0; i < 8; ++i) {
        const double f = i == 7 ? slicer.area(middle) : slicer.area(middle - half * node[i]) + slicer.area(middle + half * node[i]);
        fine += kronrod[i] * f;
        if (i % 2 == 1) coarse += gauss[i / 2] * f;
    }
    return {half * fine, std::abs(half * (fine - coarse))};
}

double integrate(const Slicer& slicer, double from, double to, double tolerance, int depth)
{
    const Estimate whole = gauss_kronrod(slicer, from, to);
    if (whole.error <= tolerance || depth == 0) return whole.value;
    const double middle = 0.5 * (from + to);
    return integrate(slicer, from, middle, 0.5 * tolerance, depth - 1) + integrate(slicer, middle, to, 0.5 * tolerance, depth - 1);
}

}  // namespace

double circle_polygon_area(const Vector3d* corners, int count, double radius)
{
    double area = 0.0;
    for (int i = 0; i < count; ++i) area += circle_edge_area(corners[i], corners[(i + 1) % count], radius);
    return area;
}

double volume_within(const Box& box, const Revolved& body)
{
    const Vector3d size = box.size();
    if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) return 0.0;
    const Slicer slicer(box, body);
    const auto s = slicer.breaks();
    const double widest =
        std::max(body.radius(body.lower), std::max(body.radius(body.upper), body.radius(0.5 * (body.lower + body.upper))));
    const double tolerance = 1e-10 * std::numbers::pi * widest * widest * (body.upper - body.lower) / static_cast<double>(s.size());
    double volume = 0.0;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        if (s[i + 1] > s[i]) volume += integrate(slicer, s[i], s[i + 1], tolerance, 30);
    return std::max(0.0, volume);
}

}  // namespace corpuscle
