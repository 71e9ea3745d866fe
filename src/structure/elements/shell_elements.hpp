#pragma once

#include <utility>
#include <variant>

#include "parallel/loops.hpp"
#include "structure/elements/shell_section.hpp"

namespace corpuscle {

/// What shells of N corners have in common.
template <std::size_t N>
class ShellElements : public BlockElements<N> {
public:
    [[nodiscard]] int point_count() const { return section_.point_count(); }

    /// An equal share of an element's mass, with a rotary inertia that lets transverse shear be no faster than plate waves.
    [[nodiscard]] CornerMass corner_mass(std::size_t element) const
    {
        const double share = this->blocks_.slot(element, slot_mass) / static_cast<double>(N);
        return {share, share * this->blocks_.slot(element, slot_gyration)};
    }
    [[nodiscard]] ElementValues values(std::size_t element) const { return section_.values(this->blocks_, element); }
    [[nodiscard]] ElementEnergy energy(std::size_t element) const
    {
        if (!this->blocks_.is_left(element)) return {};
        const double hourglass = this->blocks_.slot(element, slot_hourglass_work);
        return {this->blocks_.slot(element, slot_work) - hourglass, this->blocks_.slot(element, slot_plastic_work), hourglass};
    }
    /// Stress and history of one point through the thickness, in the element's axes.
    [[nodiscard]] PlanePoint<double> point(std::size_t element, int point) const { return section_.point(this->blocks_, element, point); }

protected:
    /// What every shell keeps first.
    enum Slot : int {
        slot_thickness = 0,       ///< [m]
        slot_mass = 1,            ///< [kg]
        slot_gyration = 2,        ///< rotary inertia over mass [m2]
        slot_work = 3,            ///< done on the element by its corners [J]
        slot_hourglass_work = 4,  ///< [J]
        slot_plastic_work = 5,    ///< [J]
        shell_slot_count = 6,
    };

    ShellElements() = default;
    /// Elements whose points' numbers begin at slot `slot_points`.
    ShellElements(ShellInput<N> input, const Material& material, int slot_points)
        : BlockElements<N>(std::move(input.corners),
                           slot_points + static_cast<int>(input.points.size()) * slots_of_point(material.strength, plane_slots)),
          section_(std::move(input.points), material, input.shear_factor, {slot_thickness, slot_plastic_work, slot_points}),
          hourglass_(input.hourglass)
    {
    }

    /// body(law, block) for every block, if the material's law is one for shells.
    template <class Body>
    void for_each_block(const Body& body)
    {
        std::visit(
            [&]<class Law>(const Law& law) {
                if constexpr (for_shells<Law>())
                    for_each_dynamic(this->blocks_.block_count(), blocks_at_a_time, [&](std::size_t b) { body(law, b); });
            },
            section_.strength);
    }

    ShellSection section_;
    HourglassControl hourglass_;
};

}  // namespace corpuscle
