#pragma once

#include <span>
#include <string>

#include "mesh/mesh.hpp"
#include "structure/elements/solid_elements.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Four-node tetrahedra whose growth of volume is averaged at the nodes (after Bonet and Burton 1998, Commun. Numer. Methods Eng. 14,
/// 437): the mean of the four nodes' means takes the place of each one's own, and the pressure acts through the same means, so that
/// plastic flow does not lock and energy is kept. Computed `lane_count` elements side by side.
class Tetrahedra : public SolidElements<4> {
public:
    Tetrahedra() = default;
    /// Undeformed elements at the nodes' reference positions.
    Tetrahedra(const SolidInput<4>& input, const Material& material, const Nodes& nodes);

    [[nodiscard]] const char* kind() const { return "tetrahedron"; }
    [[nodiscard]] ElementShape shape(std::size_t) const { return ElementShape::tetrahedron; }

    /// As of `Bricks`, with 4 corners an element.
    std::size_t resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads);

    [[nodiscard]] ElementValues values(std::size_t element) const;
    /// Stress and history of the element's point, in global axes.
    [[nodiscard]] SolidPoint<double> point(std::size_t element) const;

    std::vector<Field> state(const std::string& prefix) { return blocks_.state(prefix, "tetrahedra"); }

private:
    void connect();
    [[nodiscard]] Lanes allowed_step(const LaneCorners<4>& place, const Lanes& mass, const Lanes& bulk) const;
    void measure_growth(const Nodes& nodes, double duration, std::size_t b);
    void average_at_nodes();
    [[nodiscard]] Lanes mean_of_corners(std::size_t b) const;
    template <class Law>
    void stretch_block(const Law& law, const Nodes& nodes, double duration, std::size_t b);
    template <class Law>
    void load_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads);

    std::uint32_t first_node_ = 0;         ///< the part's nodes follow it
    std::vector<std::uint32_t> begin_;     ///< of each node's elements in around_; node count + 1
    std::vector<std::uint32_t> around_;    ///< elements at each node
    std::vector<double> volume_, amount_;  ///< of each element: its volume [m3], and what is to be averaged, times it
    std::vector<double> node_mean_;        ///< of each node
    std::vector<double> viscous_;          ///< viscous pressure of each element [Pa]
};

}  // namespace corpuscle
