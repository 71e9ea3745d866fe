#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "structure/elements/shell_elements.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Four-node shells after Belytschko, Lin and Tsay: one point in the plane, several through the thickness, axes that turn with
/// the element, thickness that follows the strain. Computed `lane_count` elements side by side.
class QuadrilateralShells : public ShellElements<4> {
public:
    QuadrilateralShells() = default;
    /// Undeformed shells at the nodes' reference positions.
    QuadrilateralShells(ShellInput<4> input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return "shell"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::quadrilateral; }

    /// Takes the step's strain from the nodes' velocities, finds stresses, and writes the loads of 4 corners an element.
    /// Returns the index of the first element whose energy or shape is no longer a number, or size(). `duration` [s] > 0.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "shells"); }

private:
    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    ShellHourglass<Lanes> resist_hourglass(const QuadFrame<Lanes>& frame, const ShellHourglass<Lanes>& change, double duration,
                                           Lanes* own) const;
    [[nodiscard]] Lanes allowed_step(const QuadFrame<Lanes>& frame, const Lanes* own) const;
};

}  // namespace corpuscle
