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

/// Three-node C0 shells: constant strain and curvature; transverse shear read along the three edges and put together at the middle (as in
/// Lee and Bathe's MITC3, 2004, Comput. Struct. 82, 945), with an elastic force against the shear that runs round the edges, which the
/// middle does not see. Axes turn with the element by the polar decomposition of its deformation in the plane. With one point and no
/// shear factor they are membranes. Computed `lane_count` elements side by side.
class TriangleShells : public ShellElements<3> {
public:
    TriangleShells() = default;
    /// Undeformed shells at the nodes' reference positions.
    TriangleShells(ShellInput<3> input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return is_membrane() ? "membrane" : "triangle shell"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::triangle; }
    [[nodiscard]] bool is_membrane() const { return section_.shear_factor == 0; }

    /// As of `QuadrilateralShells`, with 3 corners an element.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "triangles"); }

private:
    struct Frame;
    using Corners = LaneCorners<3>;

    [[nodiscard]] Frame frame_of(const Corners& place, const Lanes* own) const;
    template <class Law>
    void resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);
    [[nodiscard]] Lanes circulation_stiffness(const Lanes* own) const;
    [[nodiscard]] Lanes drill_stiffness(const Frame& f, const Lanes* own) const;
    Lanes resist_unseen(const Lanes& stiffness, const Lanes& change, int slot, Lanes* own) const;
    [[nodiscard]] Lanes gyration(const Frame& f, const Lanes& thickness) const;
    [[nodiscard]] Lanes allowed_step(const Frame& f, const Lanes* own) const;
};

}  // namespace corpuscle
