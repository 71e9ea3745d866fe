#include "euler/axis.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// r^power and its integral from a to b; the integral by the mean over the way, so that thin shells far out lose no digits.
double power_of(double r, int power)
{
    return power == 0 ? 1 : power == 1 ? r : r * r;
}
double integral(double a, double b, int power)
{
    const double mean = power == 0 ? 1 : power == 1 ? 0.5 * (a + b) : (a * a + a * b + b * b) / 3;
    return (b - a) * mean;
}

}  // namespace

EulerAxis euler_axis(std::vector<double> faces, int power)
{
    if (faces.size() < 2) throw InputError("an axis of the Euler grid has no cells", "give at least two faces");
    for (std::size_t i = 1; i < faces.size(); ++i) {
        if (!(faces[i] > faces[i - 1])) throw InputError("faces of the Euler grid do not ascend", "give each face beyond the one before");
    }
    if (power > 0 && faces.front() < 0) throw InputError("a radius of the Euler grid is below 0", "begin radial axes at 0 or beyond");
    EulerAxis axis;
    axis.curved = power > 0;
    for (const double face : faces) axis.area.push_back(power_of(face, power));
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) axis.volume.push_back(integral(faces[i], faces[i + 1], power));
    axis.faces = std::move(faces);
    return axis;
}

std::vector<double> even_faces(double lower, double upper, std::size_t cells)
{
    std::vector<double> faces(cells + 1);
    const double count = static_cast<double>(cells);
    for (std::size_t i = 0; i <= cells; ++i) faces[i] = lower + (upper - lower) * static_cast<double>(i) / count;
    return faces;
}

std::vector<double> graded_faces(double from, double to, double first, double last)
{
    // n cells of a geometric row sum to (to - from): last = first ratio^(n-1), sum = (last ratio - first)/(ratio - 1).
    const double length = std::abs(to - from), mean = std::abs(last / first - 1) < 1e-9 ? first : (last - first) / std::log(last / first);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / mean)));
    const double ratio = count > 1 ? std::pow(last / first, 1.0 / static_cast<double>(count - 1)) : 1.0;
    std::vector<double> faces{from};
    double width = 1;
    for (std::size_t i = 0; i < count; ++i, width *= ratio) faces.push_back(faces.back() + width);
    const double scale = (to - from) / (faces.back() - from);
    for (double& face : faces) face = from + (face - from) * scale;
    faces.back() = to;
    return faces;
}

std::vector<double> faces_with_fine_part(double lower, double upper, std::array<double, 2> fine, double size, double last)
{
    const double count = std::max(1.0, std::round((fine[1] - fine[0]) / size));
    const std::vector<double> even = even_faces(fine[0], fine[1], static_cast<std::size_t>(count));
    const double width = (fine[1] - fine[0]) / count;
    std::vector<double> faces;
    if (fine[0] > lower) {
        const std::vector<double> below = graded_faces(fine[0], lower, width, last);
        faces.assign(below.rbegin(), below.rend() - 1);
    }
    faces.insert(faces.end(), even.begin(), even.end());
    if (fine[1] < upper) {
        const std::vector<double> above = graded_faces(fine[1], upper, width, last);
        faces.insert(faces.end(), above.begin() + 1, above.end());
    }
    return faces;
}

}  // namespace corpuscle
