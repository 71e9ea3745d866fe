#pragma once

#include <span>
#include <string>

#include "mesh/mesh.hpp"
#include "structure/elements/solid_elements.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Eight-node bricks with one point and hourglass control after Flanagan and Belytschko 1981. Stress lies in global axes and turns with
/// the step's mean spin. Computed `lane_count` elements side by side.
class Bricks : public SolidElements<8> {
public:
    Bricks() = default;
    /// Undeformed bricks at the nodes' reference positions.
    Bricks(const SolidInput<8>& input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return "brick"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::hexahedron; }

    /// Takes the step's strain from the nodes' velocities, finds stresses, and writes the loads of 8 corners an element.
    /// Returns the index of the first element whose energy or shape is no longer a number, or size(). `duration` [s] > 0.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    [[nodiscard]] ElementValues values(std::size_t element) const;
    [[nodiscard]] ElementEnergy energy(std::size_t element) const;
    /// Stress and history of the element's point, in global axes.
    [[nodiscard]] SolidPoint<double> point(std::size_t element) const;

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "bricks"); }

private:
    /// Forces on the four modes that the point does not see [N].
    using Hourglass = std::array<Vector3<Lanes>, 4>;

    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    Hourglass resist_hourglass(const HexGradient<Lanes>& g, const HexModes<Lanes>& place, const HexModes<Lanes>& move,
                               const Gradient3<Lanes>& gradient, const Lanes& strength, double duration, Lanes* own) const;
    [[nodiscard]] Lanes allowed_step(const HexGradient<Lanes>& g, const Lanes& mass, const Lanes& bulk) const;

    double hourglass_stiffness_ = 0, hourglass_viscosity_ = 0;
};

}  // namespace corpuscle
