#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "fields/field.hpp"
#include "mesh/mesh.hpp"
#include "structure/elements/element_values.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// Triangles and quadrilaterals that never deform: no mass, no stress, no step of their own.
class RigidFacets {
public:
    RigidFacets() = default;
    /// `elements` with the structure's node numbers.
    explicit RigidFacets(std::vector<MeshElement> elements) : elements_(std::move(elements)) {}

    [[nodiscard]] std::size_t size() const { return elements_.size(); }
    [[nodiscard]] const char* kind() const { return "rigid"; }
    [[nodiscard]] ElementShape shape(std::size_t element) const { return elements_[element].shape; }
    [[nodiscard]] int corner_count() const { return 0; }  ///< they load no corner
    [[nodiscard]] std::uint32_t node(std::size_t element, int corner) const { return elements_[element].node[corner]; }

    [[nodiscard]] CornerMass corner_mass(std::size_t) const { return {}; }
    [[nodiscard]] bool is_left(std::size_t) const { return true; }
    void remove(std::size_t) {}
    [[nodiscard]] double transit(std::size_t) const { return stable_step(); }
    std::size_t resist(const Nodes&, double, std::span<CornerLoad>) { return size(); }
    [[nodiscard]] double stable_step() const { return std::numeric_limits<double>::infinity(); }
    [[nodiscard]] ElementValues values(std::size_t) const { return {}; }
    [[nodiscard]] ElementEnergy energy(std::size_t) const { return {}; }
    std::vector<Field> state(const std::string&) { return {}; }

private:
    std::vector<MeshElement> elements_;
};

}  // namespace corpuscle
