#pragma once

#include <vector>

#include "laws/strength/material.hpp"
#include "math/quadrature.hpp"
#include "structure/elements/hourglass_control.hpp"
#include "structure/elements/point_slots.hpp"
#include "structure/elements/point_values.hpp"
#include "structure/elements/quad_shell_strain.hpp"

namespace corpuscle {

/// What shells of N corners are made from.
template <std::size_t N>
struct ShellInput {
    std::vector<std::array<std::uint32_t, N>> corners;  ///< the structure's nodes, round each element
    std::vector<double> thickness;                      ///< of each element [m]
    std::vector<QuadraturePoint> points;                ///< through the thickness, lowest first
    double shear_factor = 5.0 / 6.0;                    ///< [1]; 0 with one point: a membrane
    HourglassControl hourglass;
};

/// Where a shell keeps what its section needs.
struct SectionSlots {
    int thickness = 0;     ///< [m]
    int plastic_work = 0;  ///< [J]
    int points = 0;        ///< the points' numbers begin here
};

/// What lies across a shell, whatever its corners: the points through its thickness, and their material.
class ShellSection {
public:
    ShellSection() = default;
    ShellSection(std::vector<QuadraturePoint> through, const Material& material, double factor, SectionSlots slots)
        : points(std::move(through)),
          strength(material.strength),
          stiffness(material.young_modulus, material.poisson_ratio),
          density(material.density),
          shear_factor(factor),
          slots_(slots),
          point_slots_(slots_of_point(strength, plane_slots))
    {
    }

    std::vector<QuadraturePoint> points;
    Strength strength;
    PlaneStiffness stiffness{1.0, 0.0};
    double density = 0;       ///< [kg/m3]
    double shear_factor = 0;  ///< [1]

    [[nodiscard]] int point_count() const { return static_cast<int>(points.size()); }

    /// New stresses of the points and the new thickness; returns forces and moments per area. Counts the plastic work of the element's
    /// `area` in the middle of the step.
    template <class Law>
    ShellResultant<Lanes> stretch(const Law& law, const ShellStrain<Lanes>& strain, const Lanes& area, double duration, Lanes* own) const;

    /// Stress and history of one point.
    [[nodiscard]] PlanePoint<double> point(const ElementBlocks& blocks, std::size_t element, int p) const
    {
        return point_of<PlanePoint<double>>(strength, blocks, element, slots_.points + p * point_slots_);
    }

    [[nodiscard]] ElementValues values(const ElementBlocks& blocks, std::size_t element) const
    {
        ElementValues v = values_of_points(point_count(), [&](int p) { return point(blocks, element, p); });
        v.thickness = blocks.slot(element, slots_.thickness);
        return v;
    }

private:
    SectionSlots slots_;
    int point_slots_ = 0;  ///< numbers of a point
};

template <class Law>
ShellResultant<Lanes> ShellSection::stretch(const Law& law, const ShellStrain<Lanes>& strain, const Lanes& area, double duration,
                                            Lanes* own) const
{
    const Lanes thickness = load_slot(own, slots_.thickness);
    const Lanes half_thickness = 0.5 * thickness;
    ShellResultant<Lanes> sum{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    Lanes across = 0.0, plastic_work = 0.0;
    for (int p = 0; p < point_count(); ++p) {
        const int first = slots_.points + p * point_slots_;
        const double position = points[p].position, weight = points[p].weight;
        const Lanes height = position * half_thickness;
        const PlaneStrain<Lanes> e{strain.xx + height * strain.bend_xx, strain.yy + height * strain.bend_yy,
                                   strain.xy + height * strain.bend_xy, strain.yz, strain.zx};
        PlanePoint<Lanes> point = load_point<PlanePoint<Lanes>>(law, own, first);
        const PlaneResponse<Lanes> response = law.stretch(stiffness, point, e, duration);
        store_point(law, point, own, first);
        across = across + 0.5 * weight * response.thickness_strain;
        plastic_work = plastic_work + 0.5 * weight * response.plastic_work;
        const PlaneStress<Lanes>& s = point.stress;
        sum.xx = sum.xx + weight * s.xx;
        sum.yy = sum.yy + weight * s.yy;
        sum.xy = sum.xy + weight * s.xy;
        sum.bend_xx = sum.bend_xx + weight * position * s.xx;
        sum.bend_yy = sum.bend_yy + weight * position * s.yy;
        sum.bend_xy = sum.bend_xy + weight * position * s.xy;
        sum.zx = sum.zx + weight * s.zx;
        sum.yz = sum.yz + weight * s.yz;
    }
    const Lanes now = thickness * (1.0 + across), half = 0.5 * now;
    store_slot(own, slots_.thickness, now);
    if constexpr (Law::yields())
        store_slot(own, slots_.plastic_work, load_slot(own, slots_.plastic_work) + area * thickness * plastic_work);
    const Lanes lever = half * half, shear = half * shear_factor;
    return {sum.xx * half,       sum.yy * half,       sum.xy * half,  sum.bend_xx * lever,
            sum.bend_yy * lever, sum.bend_xy * lever, sum.zx * shear, sum.yz * shear};
}

}  // namespace corpuscle
