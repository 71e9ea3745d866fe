#pragma once

#include <span>
#include <string>

#include "mesh/mesh.hpp"
#include "structure/elements/solid_elements.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Eight-node bricks with two points along each direction; the growth of volume is read as the element's mean (selectively reduced, after
/// Hughes 1980, Int. J. Numer. Methods Eng. 15, 1413), so that plastic flow does not lock. No hourglass modes; slow, and stiff in the
/// bending of thin layers.
class FullBricks : public SolidElements<8> {
public:
    FullBricks() = default;
    /// Undeformed bricks at the nodes' reference positions.
    FullBricks(const SolidInput<8>& input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return "full brick"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::hexahedron; }

    /// As of `Bricks`.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    [[nodiscard]] ElementValues values(std::size_t element) const;
    /// Stress and history of one of the eight points, x fastest, in global axes.
    [[nodiscard]] SolidPoint<double> point(std::size_t element, int point) const;

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "bricks"); }

private:
    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    template <class Law>
    Lanes stretch_points(const Law& law, const HexModes<Lanes>& place, const HexModes<Lanes>& move, double duration, Lanes* own);
    [[nodiscard]] Lanes allowed_step(const HexModes<Lanes>& place, const Lanes& mass, const Lanes& bulk) const;

    int point_slots_ = 0;
};

}  // namespace corpuscle
