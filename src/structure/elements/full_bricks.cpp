#include "structure/elements/full_bricks.hpp"

#include <cmath>
#include <numbers>

#include "structure/elements/point_values.hpp"

namespace corpuscle {

namespace {

/// What an element keeps besides what all solids do, by slot.
enum FullBrickSlot : int {
    slot_loads = 3,  ///< modal loads on the corners
    slot_points = 24,
};

constexpr int point_count = 8;

using Modes = HexModes<Lanes>;
using Vector = Vector3<Lanes>;

/// Where a point lies in the element: each coordinate +-1/sqrt(3).
struct PointPlace {
    explicit PointPlace(int p)
        : xi(p & 1 ? std::numbers::inv_sqrt3 : -std::numbers::inv_sqrt3),
          eta(p & 2 ? std::numbers::inv_sqrt3 : -std::numbers::inv_sqrt3),
          zeta(p & 4 ? std::numbers::inv_sqrt3 : -std::numbers::inv_sqrt3)
    {
    }
    double xi, eta, zeta;
};

/// Derivatives along the element's own coordinates at a point of what has the modes `m`.
struct Tangents {
    Tangents(const Modes& m, const PointPlace& p)
        : xi(m.x + m.xy * Lanes(p.eta) + m.zx * Lanes(p.zeta) + m.twist * Lanes(p.eta * p.zeta)),
          eta(m.y + m.xy * Lanes(p.xi) + m.yz * Lanes(p.zeta) + m.twist * Lanes(p.xi * p.zeta)),
          zeta(m.z + m.yz * Lanes(p.eta) + m.zx * Lanes(p.xi) + m.twist * Lanes(p.xi * p.eta))
    {
    }
    Vector xi, eta, zeta;
};

/// The shape at a point: areas that gradients are made with, and the point's volume.
struct PointShape {
    PointShape(const Modes& place, const PointPlace& p)
    {
        const Tangents t(place, p);
        xi = cross(t.eta, t.zeta);
        eta = cross(t.zeta, t.xi);
        zeta = cross(t.xi, t.eta);
        volume = dot(t.xi, xi);
    }
    [[nodiscard]] Gradient3<Lanes> gradient(const Tangents& u) const
    {
        const Lanes inverse = 1.0 / volume;
        Gradient3<Lanes> g{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        g.add(u.xi, xi * inverse);
        g.add(u.eta, eta * inverse);
        g.add(u.zeta, zeta * inverse);
        return g;
    }
    Vector xi, eta, zeta;  ///< [m2]
    Lanes volume;          ///< [m3]
};

/// Adds the modal loads of one point's stress.
void add_load(Modes& load, const SolidStress<Lanes>& s, const PointShape& shape, const PointPlace& p)
{
    const Vector xi = traction(s, shape.xi), eta = traction(s, shape.eta), zeta = traction(s, shape.zeta);
    load.x += xi;
    load.y += eta;
    load.z += zeta;
    load.xy += xi * Lanes(p.eta) + eta * Lanes(p.xi);
    load.zx += xi * Lanes(p.zeta) + zeta * Lanes(p.xi);
    load.yz += eta * Lanes(p.zeta) + zeta * Lanes(p.eta);
    load.twist += xi * Lanes(p.eta * p.zeta) + eta * Lanes(p.xi * p.zeta) + zeta * Lanes(p.xi * p.eta);
}

/// Modal loads of the points' stresses, their mean stresses put in the place of each one's own, less the viscous pressure.
Modes load_of(const Modes& place, const std::array<SolidStress<Lanes>, point_count>& stress, const Lanes& viscous)
{
    Lanes volume = 0.0, mean = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const Lanes own = PointShape(place, PointPlace(p)).volume;
        volume = volume + own;
        mean = mean + own * mean_stress(stress[p]);
    }
    mean = mean / volume - viscous;
    Modes load;
    for (Vector* v : {&load.mean, &load.x, &load.y, &load.z, &load.yz, &load.zx, &load.xy, &load.twist}) *v = {0.0, 0.0, 0.0};
    for (int p = 0; p < point_count; ++p) {
        const PointPlace at(p);
        add_load(load, with_mean_added(stress[p], Lanes(mean - mean_stress(stress[p]))), PointShape(place, at), at);
    }
    return load;
}

}  // namespace

FullBricks::FullBricks(const SolidInput<8>& input, const Material& material, const Nodes& nodes)
    : SolidElements(input, material, slot_points + point_count * slots_of_point(material.strength, solid_slots)),
      point_slots_(slots_of_point(material.strength, solid_slots))
{
    for (std::size_t b = 0; b < blocks_.block_count(); ++b) {
        const Modes place = modes_of(gather(nodes.reference, corners_of_block(b)));
        const Lanes mass = material_.density * gradient_of(place).volume;
        store_slot(blocks_.block(b), slot_mass, mass);
        std::visit(
            [&](const auto& law) {
                const SolidPoint<Lanes> point;
                for (int p = 0; p < point_count; ++p) store_point(law, point, blocks_.block(b), slot_points + p * point_slots_);
                blocks_.set_transit(b, allowed_step(place, mass, bulk_at(law, material_.stiffness, point)));
            },
            material_.strength);
    }
    blocks_.review();
}

std::size_t FullBricks::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    for_each_block([&](const auto& law, std::size_t b) { resist_block(law, nodes, duration, b, loads); });
    return blocks_.review();
}

/// The step of one block: motion to strain in the middle of the step, strain to stress, stress to loads at its end.
template <class Law>
void FullBricks::resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    if (blocks_.gone(b)) return;
    const auto* corners = corners_of_block(b);
    Lanes* own = blocks_.block(b);
    const Modes end = modes_of(gather_left(blocks_, b, nodes.position, nodes.reference, corners));
    const Modes move = modes_of(gather_way(blocks_, b, nodes.velocity, duration, corners));
    const Lanes viscous = stretch_points(law, halfway(end, move), move, duration, own);
    std::array<SolidStress<Lanes>, point_count> stress;
    Lanes stiffest = 0.0;
    for (int p = 0; p < point_count; ++p) {
        const SolidPoint<Lanes> point = load_point<SolidPoint<Lanes>>(law, own, slot_points + p * point_slots_);
        stress[p] = point.stress;
        stiffest = larger(stiffest, bulk_at(law, material_.stiffness, point));
    }
    const Modes load = load_of(end, stress, viscous);
    const Lanes work = exchange_work<7>(own, slot_loads, {&load.x, &load.y, &load.z, &load.yz, &load.zx, &load.xy, &load.twist},
                                        {&move.x, &move.y, &move.z, &move.yz, &move.zx, &move.xy, &move.twist});
    const Lanes total = load_slot(own, slot_work) + work;
    store_slot(own, slot_work, total);
    write_loads<8>(blocks_, b, corners_of(load), nullptr, loads.data());
    const Lanes ratio = viscous / (load_slot(own, slot_mass) / gradient_of(end).volume * material_.wave_speed() * material_.wave_speed());
    const Lanes step = allowed_step(end, load_slot(own, slot_mass), stiffest) / (1.0 + ratio);
    blocks_.set_transit(b, step + 0.0 * total);  // not above 0 if anything has gone wrong
}

/// New stresses of the points, each turned by its own spin; the growth of volume is the element's. Returns the viscous pressure. [Pa]
template <class Law>
Lanes FullBricks::stretch_points(const Law& law, const Modes& place, const Modes& move, double duration, Lanes* own)
{
    const HexGradient<Lanes> mean = gradient_of(place);
    const Lanes growth = volume_strain(mean_gradient(mean, move).strain());
    const ViscousPressure<Lanes> viscous =
        viscous_pressure(viscosity_, material_, cube_root(mean.volume), Lanes(load_slot(own, slot_mass) / mean.volume), growth, duration);
    Lanes plastic = load_slot(own, slot_plastic_work);
    for (int p = 0; p < point_count; ++p) {
        const PointPlace at(p);
        const PointShape shape(place, at);
        const Gradient3<Lanes> gradient = shape.gradient(Tangents(move, at));
        SolidStrain<Lanes> strain = gradient.strain();
        const Lanes rest = (growth - volume_strain(strain)) * (1.0 / 3.0);
        strain.xx = strain.xx + rest;
        strain.yy = strain.yy + rest;
        strain.zz = strain.zz + rest;
        SolidPoint<Lanes> point = load_point<SolidPoint<Lanes>>(law, own, slot_points + p * point_slots_);
        plastic =
            plastic + shape.volume * advance_point(law, material_.stiffness, point, StepRotation<Lanes>(gradient.spin()), strain, duration);
        heat_by_viscosity<Law>(point, viscous.pressure, growth);
        store_point(law, point, own, slot_points + p * point_slots_);
    }
    store_slot(own, slot_plastic_work, plastic);
    return viscous.pressure;
}

/// 2 / (a bound of the highest frequency): the parts of volume and of shape, each by its own gradients. [s]
Lanes FullBricks::allowed_step(const Modes& place, const Lanes& mass, const Lanes& bulk) const
{
    const HexGradient<Lanes> mean = gradient_of(place);
    GradientSquares<Lanes> of_volume;
    const Lanes scale = 1.0 / (std::sqrt(8.0) * mean.volume);
    for (const Vector* v : {&mean.x, &mean.y, &mean.z, &mean.yz, &mean.zx, &mean.xy}) of_volume.add(*v * scale);
    Lanes shape_part = 0.0;
    Lanes sound = 1.0;
    for (int p = 0; p < point_count; ++p) {
        const PointPlace at(p);
        const PointShape shape(place, at);
        GradientSquares<Lanes> g;
        const Lanes inverse = 1.0 / shape.volume;
        for (int corner = 0; corner < 8; ++corner) {
            const double x = corner % 4 == 1 || corner % 4 == 2 ? 1.0 : -1.0, y = corner % 4 >= 2 ? 1.0 : -1.0,
                         z = corner >= 4 ? 1.0 : -1.0;
            const Lanes along_x = 0.125 * x * (1.0 + y * at.eta) * (1.0 + z * at.zeta),
                        along_y = 0.125 * y * (1.0 + x * at.xi) * (1.0 + z * at.zeta),
                        along_z = 0.125 * z * (1.0 + x * at.xi) * (1.0 + y * at.eta);
            g.add((shape.xi * along_x + shape.eta * along_y + shape.zeta * along_z) * inverse);
        }
        shape_part = shape_part + shape.volume * g.largest();
        sound = select(shape.volume > 0.0, sound, Lanes(-1.0));
    }
    const Lanes squared = 8.0 / mass * (bulk * of_volume.trace() * mean.volume + 2.0 * material_.stiffness.shear() * shape_part);
    return sound * 2.0 / square_root(squared);
}

SolidPoint<double> FullBricks::point(std::size_t element, int p) const
{
    return point_of<SolidPoint<double>>(material_.strength, blocks_, element, slot_points + p * point_slots_);
}

ElementValues FullBricks::values(std::size_t element) const
{
    return values_of_points(point_count, [&](int p) { return point(element, p); });
}

}  // namespace corpuscle
