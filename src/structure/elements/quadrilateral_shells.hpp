#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "structure/elements/shell_section.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Four-node shells after Belytschko, Lin and Tsay: one point in the plane, several through the thickness, axes that turn with
/// the element, thickness that follows the strain. Computed `lane_count` elements side by side.
class QuadrilateralShells : public BlockElements {
public:
    QuadrilateralShells() = default;
    /// Undeformed shells at the nodes' reference positions.
    QuadrilateralShells(ShellInput<4> input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return "shell"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::quadrilateral; }
    [[nodiscard]] int corner_count() const { return 4; }
    [[nodiscard]] std::uint32_t node(std::size_t element, int corner) const { return corners_[element][corner]; }
    [[nodiscard]] int point_count() const { return section_.point_count(); }

    /// A quarter of an element's mass, with a rotary inertia that lets transverse shear be no faster than plate waves.
    [[nodiscard]] CornerMass corner_mass(std::size_t element) const;

    /// Takes the step's strain from the nodes' velocities, finds stresses, and writes the loads of 4 corners an element.
    /// Returns the index of the first element whose energy or shape is no longer a number, or size(). `duration` [s] > 0.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    [[nodiscard]] ElementValues values(std::size_t element) const { return section_.values(blocks_, element); }
    [[nodiscard]] ElementEnergy energy(std::size_t element) const;
    /// Stress and history of one point through the thickness, in the element's axes.
    [[nodiscard]] PlanePoint<double> point(std::size_t element, int point) const { return section_.point(blocks_, element, point); }

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "shells"); }

private:
    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    ShellHourglass<Lanes> resist_hourglass(const QuadFrame<Lanes>& frame, const ShellHourglass<Lanes>& change, double duration,
                                           Lanes* own) const;
    [[nodiscard]] Lanes allowed_step(const QuadFrame<Lanes>& frame, const Lanes* own) const;

    std::vector<std::array<std::uint32_t, 4>> corners_;  ///< whole blocks: the last element is repeated to fill its block
    ShellSection section_;
    HourglassControl hourglass_;
};

}  // namespace corpuscle
