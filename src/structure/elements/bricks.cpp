#include "structure/elements/bricks.hpp"

#include <cmath>

#include "structure/elements/point_values.hpp"

namespace corpuscle {

namespace {

/// What an element keeps besides what all solids do, by slot.
enum BrickSlot : int {
    slot_hourglass_work = 3,  ///< [J]
    slot_hourglass = 4,       ///< four elastic forces against hourglass modes
    slot_loads = 16,          ///< modal loads on the corners
    slot_point = 37,
};

using Modes = HexModes<Lanes>;
using Gradient = HexGradient<Lanes>;
using Vector = Vector3<Lanes>;

GradientSquares<Lanes> squares_of(const Gradient& g)
{
    GradientSquares<Lanes> sum;
    const Lanes scale = 1.0 / (std::sqrt(8.0) * g.volume);
    for (const Vector* v : {&g.x, &g.y, &g.z, &g.yz, &g.zx, &g.xy}) sum.add(*v * scale);
    return sum;
}

/// Modal loads of a stress and of hourglass forces, which do no work on linear fields.
Modes load_of(const Gradient& g, const Modes& place, const SolidStress<Lanes>& stress, const std::array<Vector, 4>& hourglass)
{
    const Vector* shapes[] = {&place.yz, &place.zx, &place.xy, &place.twist};
    const Lanes inverse = 1.0 / g.volume;
    const auto on = [&](const Vector& along) {
        Vector load = traction(stress, along);
        for (int i = 0; i < 4; ++i) load -= hourglass[i] * (dot(*shapes[i], along) * inverse);
        return load;
    };
    Modes load;
    load.mean = {0.0, 0.0, 0.0};
    load.x = on(g.x);
    load.y = on(g.y);
    load.z = on(g.z);
    load.yz = on(g.yz) + hourglass[0];
    load.zx = on(g.zx) + hourglass[1];
    load.xy = on(g.xy) + hourglass[2];
    load.twist = hourglass[3];
    return load;
}

}  // namespace

Bricks::Bricks(const SolidInput<8>& input, const Material& material, const Nodes& nodes)
    : SolidElements(input, material, slot_point + slots_of_point(material.strength, solid_slots)),
      hourglass_stiffness_(input.hourglass_stiffness),
      hourglass_viscosity_(input.hourglass_viscosity)
{
    for (std::size_t b = 0; b < blocks_.block_count(); ++b) {
        const Gradient g = gradient_of(modes_of(gather(nodes.reference, corners_of_block(b))));
        const Lanes mass = material_.density * g.volume;
        store_slot(blocks_.block(b), slot_mass, mass);
        std::visit(
            [&](const auto& law) {
                SolidPoint<Lanes> point;
                store_point(law, point, blocks_.block(b), slot_point);
                blocks_.set_transit(b, allowed_step(g, mass, bulk_at(law, material_.stiffness, point)));
            },
            material_.strength);
    }
    blocks_.review();
}

std::size_t Bricks::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    for_each_block([&](const auto& law, std::size_t b) { resist_block(law, nodes, duration, b, loads); });
    return blocks_.review();
}

/// The step of one block: motion to strain in the middle of the step, strain to stress, stress to loads at its end.
template <class Law>
void Bricks::resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    if (blocks_.gone(b)) return;
    const auto* corners = corners_of_block(b);
    Lanes* own = blocks_.block(b);
    const Modes end = modes_of(gather_left(blocks_, b, nodes.position, nodes.reference, corners));
    const Modes move = modes_of(gather_way(blocks_, b, nodes.velocity, duration, corners));
    const Modes middle = halfway(end, move);
    const Gradient g = gradient_of(middle);
    const Gradient3<Lanes> gradient = mean_gradient(g, move);
    const SolidStrain<Lanes> strain = gradient.strain();
    const Lanes growth = volume_strain(strain), mass = load_slot(own, slot_mass);

    const ViscousPressure<Lanes> viscous =
        viscous_pressure(viscosity_, material_, cube_root(g.volume), Lanes(mass / g.volume), growth, duration);
    SolidPoint<Lanes> point = load_point<SolidPoint<Lanes>>(law, own, slot_point);
    const Lanes plastic = advance_point(law, material_.stiffness, point, StepRotation<Lanes>(gradient.spin()), strain, duration);
    heat_by_viscosity<Law>(point, viscous.pressure, growth);
    store_point(law, point, own, slot_point);
    store_slot(own, slot_plastic_work, load_slot(own, slot_plastic_work) + g.volume * plastic);
    const Hourglass hourglass = resist_hourglass(g, middle, move, gradient, strength_at(law, point), duration, own);

    const Gradient now = gradient_of(end);
    const Modes load = load_of(now, end, with_mean_added(point.stress, Lanes(-viscous.pressure)), hourglass);
    const Lanes work = exchange_work<7>(own, slot_loads, {&load.x, &load.y, &load.z, &load.yz, &load.zx, &load.xy, &load.twist},
                                        {&move.x, &move.y, &move.z, &move.yz, &move.zx, &move.xy, &move.twist});
    const Lanes total = load_slot(own, slot_work) + work;
    store_slot(own, slot_work, total);
    write_loads<8>(blocks_, b, corners_of(load), nullptr, loads.data());
    const Lanes step = allowed_step(now, mass, bulk_at(law, material_.stiffness, point)) * viscous.step_share;
    blocks_.set_transit(b, select(now.volume > 0.0, step, Lanes(-1.0)) + 0.0 * total);  // not above 0 if anything has gone wrong
}

/// Forces against the hourglass modes: elastic ones that remember and turn with the element, and viscous ones; counts their work. The
/// elastic ones yield as the material does (`strength` [Pa]): an hourglass strain beyond the yield strain makes no more force, or it would
/// hold a body together that flows.
Bricks::Hourglass Bricks::resist_hourglass(const Gradient& g, const Modes& place, const Modes& move, const Gradient3<Lanes>& gradient,
                                           const Lanes& strength, double duration, Lanes* own) const
{
    const Vector* shapes[] = {&place.yz, &place.zx, &place.xy, &place.twist};
    const Vector* moves[] = {&move.yz, &move.zx, &move.xy, &move.twist};
    const StepRotation<Lanes> turn(gradient.spin());
    const Lanes full = 4.0 * material_.stiffness.uniaxial() * g.volume * squares_of(g).trace();
    const Lanes stiffness = hourglass_stiffness_ * full;
    const Lanes limit = 4.0 * hourglass_stiffness_ * strength * g.volume * square_root(squares_of(g).trace());
    const Lanes drag = hourglass_viscosity_ / duration * square_root(full * load_slot(own, slot_mass));
    Hourglass forces;
    Lanes spent = load_slot(own, slot_hourglass_work);
    for (int i = 0; i < 4; ++i) {
        const Vector change = *moves[i] - gradient * *shapes[i];
        const Vector before = turn * load_vector(own, slot_hourglass + 3 * i), trial = before + change * stiffness;
        const Lanes square = dot(trial, trial);
        const Vector after = trial * select(square > limit * limit, limit / square_root(square + 1e-300), Lanes(1.0));
        store_vector(own, slot_hourglass + 3 * i, after);
        forces[i] = after + change * drag;
        spent = spent + dot((before + after) * Lanes(0.5) + change * drag, change);
    }
    store_slot(own, slot_hourglass_work, spent);
    return forces;
}

/// 2 / (highest frequency): of the strains the point sees, or of the hourglass modes. [s]
Lanes Bricks::allowed_step(const Gradient& g, const Lanes& mass, const Lanes& bulk) const
{
    const GradientSquares<Lanes> squares = squares_of(g);
    const Lanes seen = frequency_squared<Lanes>(squares, 8.0, g.volume / mass, bulk, material_.stiffness.shear());
    const Lanes unseen = 4.0 * hourglass_stiffness_ * material_.stiffness.uniaxial() * squares.trace() * g.volume / mass;
    return 2.0 / square_root(larger(seen, unseen));
}

SolidPoint<double> Bricks::point(std::size_t element) const
{
    return point_of<SolidPoint<double>>(material_.strength, blocks_, element, slot_point);
}

ElementValues Bricks::values(std::size_t element) const
{
    return values_of_points(1, [&](int) { return point(element); });
}

ElementEnergy Bricks::energy(std::size_t element) const
{
    ElementEnergy energy = SolidElements::energy(element);
    energy.hourglass = is_left(element) ? blocks_.slot(element, slot_hourglass_work) : 0.0;
    energy.internal -= energy.hourglass;
    return energy;
}

}  // namespace corpuscle
