#include "structure/elements/quadrilateral_shells.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle {

namespace {

/// What an element keeps besides what all shells do, by slot.
enum QuadSlot : int {
    slot_hourglass = 6,  ///< seven elastic forces and moments against hourglass modes
    slot_points = 13,
};

using LaneFrame = QuadFrame<Lanes>;
using LaneModes = QuadModes<Lanes>;

/// The place in the middle of the step. [m]
LaneModes halfway(const LaneModes& end, const LaneModes& move)
{
    const Lanes half = 0.5;
    return {end.mean - move.mean * half, end.s - move.s * half, end.t - move.t * half, end.twist - move.twist * half};
}

/// Smallest rotary inertia over mass with which bending and transverse shear are no faster than plate waves. [m2]
double gyration(const GradientSum<double>& g, const PlaneStiffness& k, double shear_factor, double thickness)
{
    const double room = k.plane() / (shear_factor * k.shear()) * membrane_eigenvalue(g, k.poisson()) - largest_gradient(g);
    return std::max(thickness * thickness / 12.0, 0.25 / room);
}

QuadFrame<double> reference_frame(const std::array<std::uint32_t, 4>& corners, const Nodes& nodes)
{
    QuadCorners<double> places;
    for (int c = 0; c < 4; ++c) places[c] = nodes.reference[corners[c]];
    return frame_of(modes_of(places));
}

}  // namespace

QuadrilateralShells::QuadrilateralShells(ShellInput<4> input, const Material& material, const Nodes& nodes)
    : ShellElements(input, material, slot_points)
{
    fill_blocks(input.thickness);
    for (std::size_t e = 0; e < corners_.size(); ++e) {
        const QuadFrame<double> frame = reference_frame(corners_[e], nodes);
        const double thickness = input.thickness[e];
        blocks_.set_slot(e, slot_thickness, thickness);
        blocks_.set_slot(e, slot_mass, material.density * frame.area * thickness);
        blocks_.set_slot(e, slot_gyration, gyration(gradient_sum(frame), section_.stiffness, section_.shear_factor, thickness));
    }
    for (std::size_t b = 0; b < blocks_.block_count(); ++b)
        blocks_.set_transit(b, allowed_step(frame_of(modes_of(gather(nodes.reference, corners_of_block(b)))), blocks_.block(b)));
    blocks_.review();
}

std::size_t QuadrilateralShells::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    for_each_block([&](const auto& law, std::size_t b) { resist_block(law, nodes, duration, b, loads); });
    return blocks_.review();
}

/// The step of one block: motion to strain in the axes of the middle of the step, strain to stress, stress to loads in the axes of its end.
template <class Law>
void QuadrilateralShells::resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    const auto* corners = corners_of_block(b);
    if (blocks_.gone(b)) return;
    blocks_.fetch_ahead(b + 1);
    Lanes* own = blocks_.block(b);
    const LaneModes end = modes_of(gather_left(blocks_, b, nodes.position, nodes.reference, corners));
    const LaneCorners<4> moves = gather_way(blocks_, b, nodes.velocity, duration, corners);
    const LaneCorners<4> turns = gather_way(blocks_, b, nodes.angular_velocity, duration, corners);
    const LaneModes move = modes_of(moves), turn = modes_of(turns);

    const LaneFrame middle = frame_of(halfway(end, move));
    const LaneModes local_move = middle.to_local(move), local_turn = middle.to_local(turn);
    ShellResultant<Lanes> result = section_.stretch(law, strain_of(middle, local_move, local_turn), middle.area, duration, own);
    const ShellHourglass<Lanes> hourglass = resist_hourglass(middle, hourglass_of(middle, local_move, local_turn), duration, own);

    const LaneFrame frame = frame_of(end);
    for (Lanes* r : {&result.xx, &result.yy, &result.xy, &result.bend_xx, &result.bend_yy, &result.bend_xy, &result.zx, &result.yz})
        *r = *r * frame.area;
    const ShellLoad<Lanes> local = load_of(frame, result, hourglass);
    const LaneCorners<4> forces = corners_of(frame.to_global(local.force)), moments = corners_of(frame.to_global(local.moment));
    const Lanes total = load_slot(own, slot_work) + exchange_loads(blocks_, b, forces, moments, moves, turns, loads.data());
    store_slot(own, slot_work, total);
    blocks_.set_transit(b, allowed_step(frame, own) + 0.0 * total);  // not a number if either is not
}

/// Forces against the hourglass modes: elastic ones that remember, and viscous ones; counts their work.
ShellHourglass<Lanes> QuadrilateralShells::resist_hourglass(const QuadFrame<Lanes>& f, const ShellHourglass<Lanes>& change, double duration,
                                                            Lanes* own) const
{
    const Lanes thickness = load_slot(own, slot_thickness);
    const GradientSum<Lanes> g = gradient_sum(f);
    const Lanes area_thickness = f.area * thickness, turn_lever = thickness * thickness * (1.0 / 12.0);
    const Lanes stretch = 2.0 * section_.stiffness.young() * area_thickness * (g.xx + g.yy);
    const Lanes shear = hourglass_.shear * section_.shear_factor * section_.stiffness.shear() * (1.0 / 3.0) * thickness * f.inverse_area;
    const Lanes membrane = hourglass_.membrane * stretch, bending = hourglass_.bending * stretch * turn_lever;
    const double damping = hourglass_.viscosity * std::sqrt(section_.density * section_.stiffness.plane()) / duration;
    const Lanes drill = hourglass_.drill * section_.stiffness.shear() * area_thickness;
    const Lanes viscous = damping * thickness * square_root(f.area), viscous_turn = viscous * turn_lever;
    const Lanes stiffnesses[] = {
        membrane, membrane, bending, bending, shear * (f.tx * f.tx + f.ty * f.ty), shear * (f.sx * f.sx + f.sy * f.sy), drill};
    const Lanes viscosities[] = {viscous, viscous, viscous_turn, viscous_turn, viscous, viscous, viscous_turn};
    const Lanes* changes[] = {&change.stretch_x, &change.stretch_y, &change.turn_x, &change.turn_y,
                              &change.shear_s,   &change.shear_t,   &change.drill};
    Lanes forces[7];
    Lanes spent = load_slot(own, slot_hourglass_work);
    for (int i = 0; i < 7; ++i) {
        const Lanes before = load_slot(own, slot_hourglass + i), rise = stiffnesses[i] * *changes[i], drag = viscosities[i] * *changes[i];
        store_slot(own, slot_hourglass + i, before + rise);
        forces[i] = before + rise + drag;
        spent = spent + (before + 0.5 * rise + drag) * *changes[i];
    }
    store_slot(own, slot_hourglass_work, spent);
    return {forces[0], forces[1], forces[2], forces[3], forces[4], forces[5], forces[6]};
}

/// 2 / (highest frequency): of plate waves, of bending where the thickness has grown, of transverse shear. [s]
Lanes QuadrilateralShells::allowed_step(const QuadFrame<Lanes>& f, const Lanes* own) const
{
    const Lanes thickness = load_slot(own, slot_thickness), gyration_now = load_slot(own, slot_gyration);
    const GradientSum<Lanes> g = gradient_sum(f);
    const Lanes bending = larger(thickness * thickness / (12.0 * gyration_now), Lanes(1.0));
    const Lanes plate = 4.0 * section_.stiffness.plane() * membrane_eigenvalue(g, section_.stiffness.poisson()) * bending;
    const Lanes shear = section_.shear_factor * section_.stiffness.shear() * (4.0 * largest_gradient(g) + 1.0 / gyration_now);
    return 2.0 * square_root(load_slot(own, slot_mass) / (f.area * thickness * larger(plate, shear)));
}

}  // namespace corpuscle
