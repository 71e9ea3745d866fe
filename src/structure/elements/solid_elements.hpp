#pragma once

#include <variant>

#include "parallel/loops.hpp"
#include "structure/elements/point_values.hpp"
#include "structure/elements/solids.hpp"

namespace corpuscle {

/// What solid elements of N corners have in common.
template <std::size_t N>
class SolidElements : public BlockElements<N> {
public:
    /// An equal share of an element's mass; solids have no rotary inertia.
    [[nodiscard]] CornerMass corner_mass(std::size_t element) const
    {
        return {this->blocks_.slot(element, slot_mass) / static_cast<double>(N), 0.0};
    }
    [[nodiscard]] ElementEnergy energy(std::size_t element) const
    {
        if (!this->blocks_.is_left(element)) return {};
        return {this->blocks_.slot(element, slot_work), this->blocks_.slot(element, slot_plastic_work), 0.0};
    }

protected:
    /// What every solid element keeps first.
    enum Slot : int {
        slot_mass = 0,          ///< [kg]
        slot_work = 1,          ///< done on the element by its corners [J]
        slot_plastic_work = 2,  ///< [J]
        solid_slot_count = 3,
    };

    SolidElements() = default;
    SolidElements(const SolidInput<N>& input, const Material& material, int slots)
        : BlockElements<N>(input.corners, slots), material_(material), viscosity_(input.viscosity)
    {
    }

    /// body(law) with the material's law, if it is one for solids.
    template <class Body>
    void with_law(const Body& body)
    {
        std::visit(
            [&]<class Law>(const Law& law) {
                if constexpr (for_solids<Law>()) body(law);
            },
            material_.strength);
    }
    /// body(law, block) for every block.
    template <class Body>
    void for_each_block(const Body& body)
    {
        with_law([&](const auto& law) {
            for_each_dynamic(this->blocks_.block_count(), blocks_at_a_time, [&](std::size_t b) { body(law, b); });
        });
    }

    SolidMaterial material_;
    BulkViscosity viscosity_;
};

}  // namespace corpuscle
