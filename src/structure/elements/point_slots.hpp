#pragma once

#include <variant>

#include "laws/strength/strength.hpp"
#include "structure/elements/element_blocks.hpp"

namespace corpuscle {

/// How many of an element's numbers a point of a law takes: stress, plastic strain, back stress, heat, damage, state of the law of
/// pressure; `stress` numbers a stress.
template <class Law>
int slots_of_point(const Law& law, int stress)
{
    return stress + (law.yields() ? 1 : 0) + (law.has_back_stress() ? stress : 0) + (heats<Law>() ? 1 : 0) + (damages<Law>() ? 1 : 0) +
           (has_equation_of_state<Law>() ? 2 : 0);
}

inline int slots_of_point(const Strength& strength, int stress)
{
    return std::visit([stress](const auto& law) { return slots_of_point(law, stress); }, strength);
}

inline constexpr int plane_slots = 5, solid_slots = 6;  ///< numbers of a stress

/// A stress from the numbers that begin at slot `first`, as read(slot) gives them.
template <class Real, class Read>
void read_stress(PlaneStress<Real>& s, const Read& read, int first)
{
    s = {read(first), read(first + 1), read(first + 2), read(first + 3), read(first + 4)};
}
template <class Real, class Read>
void read_stress(SolidStress<Real>& s, const Read& read, int first)
{
    s = {read(first), read(first + 1), read(first + 2), read(first + 3), read(first + 4), read(first + 5)};
}

template <class Real, class Write>
int write_stress(const PlaneStress<Real>& s, const Write& write, int first)
{
    write(first, s.xx);
    write(first + 1, s.yy);
    write(first + 2, s.xy);
    write(first + 3, s.yz);
    write(first + 4, s.zx);
    return first + plane_slots;
}
template <class Real, class Write>
int write_stress(const SolidStress<Real>& s, const Write& write, int first)
{
    write(first, s.xx);
    write(first + 1, s.yy);
    write(first + 2, s.zz);
    write(first + 3, s.xy);
    write(first + 4, s.yz);
    write(first + 5, s.zx);
    return first + solid_slots;
}

template <class Real>
constexpr int stress_slots(const PlaneStress<Real>&)
{
    return plane_slots;
}
template <class Real>
constexpr int stress_slots(const SolidStress<Real>&)
{
    return solid_slots;
}

/// A point whose numbers read(slot) gives, in the order of `slots_of_point` from slot `first`.
template <class Point, class Law, class Read>
Point read_point(const Law& law, const Read& read, int first)
{
    Point p;
    read_stress(p.stress, read, first);
    int slot = first + stress_slots(p.stress);
    if constexpr (Law::yields()) p.plastic_strain = read(slot++);
    if (law.has_back_stress()) {
        read_stress(p.back_stress, read, slot);
        slot += stress_slots(p.stress);
    }
    if constexpr (heats<Law>()) p.heat = read(slot++);
    if constexpr (damages<Law>()) p.damage = read(slot++);
    if constexpr (has_equation_of_state<Law>() && requires { p.volume; }) {
        p.volume = read(slot++);
        p.energy = read(slot++);
    }
    return p;
}

/// A point of each element of a block, whose numbers begin at slot `first`.
template <class Point, class Law>
Point load_point(const Law& law, const Lanes* own, int first)
{
    return read_point<Point>(law, [own](int slot) { return load_slot(own, slot); }, first);
}

/// Puts the points' numbers where `load_point` finds them.
template <class Law, class Point>
void store_point(const Law& law, const Point& p, Lanes* own, int first)
{
    const auto write = [own](int slot, const Lanes& number) { store_slot(own, slot, number); };
    int slot = write_stress(p.stress, write, first);
    if constexpr (Law::yields()) write(slot++, p.plastic_strain);
    if (law.has_back_stress()) slot = write_stress(p.back_stress, write, slot);
    if constexpr (heats<Law>()) write(slot++, p.heat);
    if constexpr (damages<Law>()) write(slot++, p.damage);
    if constexpr (has_equation_of_state<Law>() && requires { p.volume; }) {
        write(slot++, p.volume);
        write(slot++, p.energy);
    }
}

/// A point of one element.
template <class Point>
Point point_of(const Strength& strength, const ElementBlocks& blocks, std::size_t element, int first)
{
    return std::visit([&](const auto& law) { return read_point<Point>(law, [&](int slot) { return blocks.slot(element, slot); }, first); },
                      strength);
}

}  // namespace corpuscle
