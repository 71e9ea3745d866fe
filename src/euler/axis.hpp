#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace corpuscle {

/// What the cells of a grid are: boxes; rings about the axis x = 0 (x the radius, y along the axis); shells about the point x = 0.
enum class EulerSpace { planar, axisymmetric, spherical };

/// The cells along one axis and their part of volumes and areas: a cell's volume is the product over the axes, the area of its face across
/// an axis the product of that axis' `area` with the other axes' `volume`. The axis is inert if it has one cell and stands for a plane
/// symmetry: nothing flows along it.
struct EulerAxis {
    std::vector<double> faces;   ///< coordinates, one more than cells [m]
    std::vector<double> area;    ///< of the faces: 1, or the radius to the power of 1 (axisymmetric) or 2 (spherical)
    std::vector<double> volume;  ///< of the cells: integral of `area` over the cell
    bool curved = false;         ///< whether `area` changes along the axis

    [[nodiscard]] std::size_t cells() const { return volume.size(); }
    [[nodiscard]] bool inert() const { return cells() == 1; }
    [[nodiscard]] double width(std::size_t cell) const { return faces[cell + 1] - faces[cell]; }
    [[nodiscard]] double middle(std::size_t cell) const { return 0.5 * (faces[cell] + faces[cell + 1]); }
};

/// An axis with cells between ascending faces; `power` of the radius: 0 plane, 1 about an axis, 2 about a point. Errors: InputError.
[[nodiscard]] EulerAxis euler_axis(std::vector<double> faces, int power = 0);

/// Faces of `cells` equal cells from `lower` to `upper` [m].
[[nodiscard]] std::vector<double> even_faces(double lower, double upper, std::size_t cells);

/// Faces from `from` to `to` [m], below or above it, whose cells begin with width `first` and grow, each by the same ratio, towards about
/// `last`; they descend if `to` lies below `from`.
[[nodiscard]] std::vector<double> graded_faces(double from, double to, double first, double last);

/// Faces from `lower` to `upper` [m]: equal cells of about `size` within `fine`, and on either side cells that grow towards about `last`.
[[nodiscard]] std::vector<double> faces_with_fine_part(double lower, double upper, std::array<double, 2> fine, double size, double last);

}  // namespace corpuscle
