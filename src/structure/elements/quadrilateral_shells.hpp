#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fields/field.hpp"
#include "laws/strength/material.hpp"
#include "math/lanes.hpp"
#include "math/quadrature.hpp"
#include "mesh/mesh.hpp"
#include "structure/elements/element_values.hpp"
#include "structure/elements/hourglass_control.hpp"
#include "structure/elements/quad_shell_strain.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// What quadrilateral shells are made from.
struct ShellInput {
    std::vector<std::array<std::uint32_t, 4>> corners;  ///< the structure's nodes, round each element
    std::vector<double> thickness;                      ///< of each element [m]
    std::vector<QuadraturePoint> points;                ///< through the thickness, lowest first
    double shear_factor = 5.0 / 6.0;                    ///< [1]
    HourglassControl hourglass;
};

/// Four-node shells after Belytschko, Lin and Tsay: one point in the plane, several through the thickness, axes that turn with
/// the element, thickness that follows the strain. Computed `lane_count` elements side by side.
class QuadrilateralShells {
public:
    QuadrilateralShells() = default;
    /// Undeformed shells at the nodes' reference positions.
    QuadrilateralShells(ShellInput input, const Material& material, const Nodes& nodes);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::quadrilateral; }
    [[nodiscard]] int corner_count() const { return 4; }
    [[nodiscard]] std::uint32_t node(std::size_t element, int corner) const { return corners_[element][corner]; }
    [[nodiscard]] int point_count() const { return static_cast<int>(points_.size()); }

    /// A quarter of each element's mass to each corner, with a rotary inertia that lets transverse shear be no faster than plate waves.
    void add_masses(Nodes& nodes) const;

    /// Takes the step's strain from the nodes' velocities, finds stresses, and writes the loads of 4 corners an element.
    /// Returns the index of the first element whose energy or shape is no longer a number, or size(). `duration` [s] > 0.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    /// 2 / (highest frequency of any element), after the last resist. [s]
    [[nodiscard]] double stable_step() const { return stable_step_; }

    [[nodiscard]] ElementValues values(std::size_t element) const;
    [[nodiscard]] ElementEnergy energy(std::size_t element) const;
    /// Stress and history of one point through the thickness, in the element's axes.
    [[nodiscard]] PlanePoint<double> point(std::size_t element, int point) const;

    std::vector<Field> state(const std::string& prefix);

private:
    [[nodiscard]] std::size_t block_count() const { return corners_.size() / lane_count; }
    [[nodiscard]] double* block(std::size_t b) { return data_.data() + b * block_size(); }
    [[nodiscard]] const double* block(std::size_t b) const { return data_.data() + b * block_size(); }
    [[nodiscard]] std::size_t block_size() const { return static_cast<std::size_t>(slots_) * lane_count; }
    [[nodiscard]] double slot(std::size_t element, int s) const
    {
        return block(element / lane_count)[s * lane_count + element % lane_count];
    }
    [[nodiscard]] std::vector<double> elementwise() const;
    void take_elementwise(std::span<const double> values);

    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    template <class Law>
    ShellResultant<Lanes> stress_points(const Law& law, const ShellStrain<Lanes>& strain, double duration, double* own);
    ShellHourglass<Lanes> resist_hourglass(const QuadFrame<Lanes>& frame, const ShellHourglass<Lanes>& change, double duration,
                                           double* own) const;
    [[nodiscard]] Lanes transit(const QuadFrame<Lanes>& frame, const double* own) const;
    void write_loads(std::size_t b, const QuadCorners<Lanes>& forces, const QuadCorners<Lanes>& moments, std::span<CornerLoad> loads) const;
    std::size_t review();

    std::vector<std::array<std::uint32_t, 4>> corners_;  ///< whole blocks: the last element is repeated to fill its block
    std::size_t size_ = 0;
    std::vector<QuadraturePoint> points_;
    Strength strength_;
    PlaneStiffness stiffness_{1.0, 0.0};
    double density_ = 0;
    double shear_factor_ = 0;
    HourglassControl hourglass_;
    int slots_ = 0;                   ///< numbers an element keeps
    int point_slots_ = 0;             ///< of these, a point
    std::vector<double> data_;        ///< by block, number, lane
    std::vector<double> block_step_;  ///< transit of each block [s], NaN where something went wrong
    double stable_step_ = 0;          ///< [s]
};

}  // namespace corpuscle
