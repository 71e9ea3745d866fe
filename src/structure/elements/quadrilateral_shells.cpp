#include "structure/elements/quadrilateral_shells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// What an element keeps besides its points, by slot.
enum Slot : int {
    slot_thickness = 0,        ///< [m]
    slot_mass = 1,             ///< [kg]
    slot_gyration = 2,         ///< rotary inertia over mass [m2]
    slot_hourglass = 3,        ///< six elastic forces and moments against hourglass modes
    slot_work = 9,             ///< done on the element by its corners [J]
    slot_hourglass_work = 10,  ///< [J]
    slot_plastic_work = 11,    ///< [J]
    slot_loads = 12,           ///< modal loads on the corners, global axes: forces s, t, twist; moments mean, s, t, twist
    slot_points = 33,
};

constexpr int stress_slots = 5;

using LaneFrame = QuadFrame<Lanes>;
using LaneModes = QuadModes<Lanes>;
using LaneCorners = QuadCorners<Lanes>;

Lanes load_slot(const double* own, int slot)
{
    return load_lanes(own + slot * lane_count);
}

void store_slot(double* own, int slot, const Lanes& value)
{
    store_lanes(value, own + slot * lane_count);
}

Vector3<Lanes> load_vector(const double* own, int slot)
{
    return {load_slot(own, slot), load_slot(own, slot + 1), load_slot(own, slot + 2)};
}

void store_vector(double* own, int slot, const Vector3<Lanes>& v)
{
    store_slot(own, slot, v.x);
    store_slot(own, slot + 1, v.y);
    store_slot(own, slot + 2, v.z);
}

PlaneStress<Lanes> load_stress(const double* own, int slot)
{
    return {load_slot(own, slot), load_slot(own, slot + 1), load_slot(own, slot + 2), load_slot(own, slot + 3), load_slot(own, slot + 4)};
}

void store_stress(double* own, int slot, const PlaneStress<Lanes>& s)
{
    store_slot(own, slot, s.xx);
    store_slot(own, slot + 1, s.yy);
    store_slot(own, slot + 2, s.xy);
    store_slot(own, slot + 3, s.yz);
    store_slot(own, slot + 4, s.zx);
}

/// Corner values of one block's elements, side by side.
LaneCorners gather(const std::vector<Vector3d>& values, const std::array<std::uint32_t, 4>* corners)
{
    alignas(64) double side[4][3][lane_count];
    for (int lane = 0; lane < lane_count; ++lane) {
        for (int corner = 0; corner < 4; ++corner) {
            const Vector3d& v = values[corners[lane][corner]];
            side[corner][0][lane] = v.x;
            side[corner][1][lane] = v.y;
            side[corner][2][lane] = v.z;
        }
    }
    LaneCorners result;
    for (int corner = 0; corner < 4; ++corner)
        result[corner] = {load_lanes(side[corner][0]), load_lanes(side[corner][1]), load_lanes(side[corner][2])};
    return result;
}

LaneModes scaled_modes(const LaneModes& m, double factor)
{
    const Lanes by = factor;
    return {m.mean * by, m.s * by, m.t * by, m.twist * by};
}

/// The place in the middle of the step. [m]
LaneModes halfway(const LaneModes& end, const LaneModes& move)
{
    const Lanes half = 0.5;
    return {end.mean - move.mean * half, end.s - move.s * half, end.t - move.t * half, end.twist - move.twist * half};
}

/// Work of the mean of old and new modal loads on a motion; keeps the new ones. Forces have no mean mode.
Lanes exchange_work(double* own, const ShellLoad<Lanes>& load, const LaneModes& move, const LaneModes& turn)
{
    const Vector3<Lanes>* loads[] = {&load.force.s,  &load.force.t,  &load.force.twist, &load.moment.mean,
                                     &load.moment.s, &load.moment.t, &load.moment.twist};
    const Vector3<Lanes>* moves[] = {&move.s, &move.t, &move.twist, &turn.mean, &turn.s, &turn.t, &turn.twist};
    Lanes twice = 0.0;
    for (int i = 0; i < 7; ++i) {
        twice = twice + dot(*loads[i] + load_vector(own, slot_loads + 3 * i), *moves[i]);
        store_vector(own, slot_loads + 3 * i, *loads[i]);
    }
    return 0.5 * twice;
}

/// Square of the highest membrane frequency over 4 * plane modulus * area * thickness / mass: exact for a one-point element, in
/// the axes in which the gradient sum has no xy. [1/m2]
template <class Real>
Real membrane_eigenvalue(const GradientSum<Real>& g, double poisson)
{
    const Real half = 0.5 * (g.xx + g.yy), gap = 0.5 * (g.xx - g.yy);
    const Real spread = gap * gap + g.xy * g.xy;
    return half + square_root(spread + poisson * poisson * (half * half - spread));
}

/// Largest principal value of the gradient sum. [1/m2]
template <class Real>
Real largest_gradient(const GradientSum<Real>& g)
{
    const Real half = 0.5 * (g.xx + g.yy), gap = 0.5 * (g.xx - g.yy);
    return half + square_root(gap * gap + g.xy * g.xy);
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

QuadrilateralShells::QuadrilateralShells(ShellInput input, const Material& material, const Nodes& nodes)
    : corners_(std::move(input.corners)),
      size_(corners_.size()),
      points_(std::move(input.points)),
      strength_(material.strength),
      stiffness_(material.young_modulus, material.poisson_ratio),
      density_(material.density),
      shear_factor_(input.shear_factor),
      hourglass_(input.hourglass)
{
    point_slots_ = std::visit(
        [](const auto& law) { return stress_slots + (law.yields() ? 1 : 0) + (law.has_back_stress() ? stress_slots : 0); }, strength_);
    slots_ = slot_points + point_slots_ * point_count();
    while (corners_.size() % lane_count != 0) {
        corners_.push_back(corners_[size_ - 1]);
        input.thickness.push_back(input.thickness[size_ - 1]);
    }
    data_.assign(static_cast<std::size_t>(slots_) * corners_.size(), 0.0);
    block_step_.resize(block_count());
    for (std::size_t e = 0; e < corners_.size(); ++e) {
        const QuadFrame<double> frame = reference_frame(corners_[e], nodes);
        double* own = block(e / lane_count) + e % lane_count;
        const double thickness = input.thickness[e];
        own[slot_thickness * lane_count] = thickness;
        own[slot_mass * lane_count] = material.density * frame.area * thickness;
        own[slot_gyration * lane_count] = gyration(gradient_sum(frame), stiffness_, shear_factor_, thickness);
    }
    for (std::size_t b = 0; b < block_count(); ++b)
        block_step_[b] = std::experimental::hmin(transit(frame_of(modes_of(gather(nodes.reference, &corners_[b * lane_count]))), block(b)));
    review();
}

void QuadrilateralShells::add_masses(Nodes& nodes) const
{
    for (std::size_t e = 0; e < size_; ++e) {
        const double quarter = 0.25 * slot(e, slot_mass);
        for (const std::uint32_t node : corners_[e]) {
            nodes.mass[node] += quarter;
            nodes.inertia[node] += quarter * slot(e, slot_gyration);
        }
    }
}

std::size_t QuadrilateralShells::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    std::visit(
        [&](const auto& law) { for_each_dynamic(block_count(), 32, [&](std::size_t b) { resist_block(law, nodes, duration, b, loads); }); },
        strength_);
    return review();
}

/// The step of one block: motion to strain in the axes of the middle of the step, strain to stress, stress to loads in the axes of its end.
template <class Law>
void QuadrilateralShells::resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    const std::array<std::uint32_t, 4>* corners = &corners_[b * lane_count];
    double* own = block(b);
    const LaneModes end = modes_of(gather(nodes.position, corners));
    const LaneModes move = scaled_modes(modes_of(gather(nodes.velocity, corners)), duration);
    const LaneModes turn = scaled_modes(modes_of(gather(nodes.angular_velocity, corners)), duration);

    const LaneFrame middle = frame_of(halfway(end, move));
    const LaneModes local_move = middle.to_local(move), local_turn = middle.to_local(turn);
    const Lanes volume = middle.area * load_slot(own, slot_thickness);
    const Lanes plastic_before = load_slot(own, slot_plastic_work);
    ShellResultant<Lanes> result = stress_points(law, strain_of(middle, local_move, local_turn), duration, own);
    if constexpr (Law::yields()) store_slot(own, slot_plastic_work, plastic_before + volume * load_slot(own, slot_plastic_work));
    const ShellHourglass<Lanes> hourglass = resist_hourglass(middle, hourglass_of(middle, local_move, local_turn), duration, own);

    const LaneFrame frame = frame_of(end);
    for (Lanes* r : {&result.xx, &result.yy, &result.xy, &result.bend_xx, &result.bend_yy, &result.bend_xy, &result.zx, &result.yz})
        *r = *r * frame.area;
    const ShellLoad<Lanes> local = load_of(frame, result, hourglass);
    const ShellLoad<Lanes> load{frame.to_global(local.force), frame.to_global(local.moment)};
    const Lanes total = load_slot(own, slot_work) + exchange_work(own, load, move, turn);
    store_slot(own, slot_work, total);
    write_loads(b, corners_of(load.force), corners_of(load.moment), loads);
    const Lanes step = transit(frame, own) + 0.0 * total;  // not a number if either is not
    block_step_[b] = any(!(step > 0.0)) ? std::numeric_limits<double>::quiet_NaN() : std::experimental::hmin(step);
}

/// New stresses of the points through the thickness and the new thickness; resultants per area. Leaves the step's plastic work per
/// volume in its slot.
template <class Law>
ShellResultant<Lanes> QuadrilateralShells::stress_points(const Law& law, const ShellStrain<Lanes>& strain, double duration, double* own)
{
    const Lanes thickness = load_slot(own, slot_thickness);
    const Lanes half_thickness = 0.5 * thickness;
    ShellResultant<Lanes> sum{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    Lanes across = 0.0, plastic_work = 0.0;
    const bool back = law.has_back_stress();
    for (int p = 0; p < point_count(); ++p) {
        const int first = slot_points + p * point_slots_;
        const double position = points_[p].position, weight = points_[p].weight;
        const Lanes height = position * half_thickness;
        const PlaneStrain<Lanes> e{strain.xx + height * strain.bend_xx, strain.yy + height * strain.bend_yy,
                                   strain.xy + height * strain.bend_xy, strain.yz, strain.zx};
        PlanePoint<Lanes> point;
        point.stress = load_stress(own, first);
        if constexpr (Law::yields()) point.plastic_strain = load_slot(own, first + stress_slots);
        if (back) point.back_stress = load_stress(own, first + stress_slots + 1);
        const PlaneResponse<Lanes> response = law.stretch(stiffness_, point, e, duration);
        store_stress(own, first, point.stress);
        if constexpr (Law::yields()) store_slot(own, first + stress_slots, point.plastic_strain);
        if (back) store_stress(own, first + stress_slots + 1, point.back_stress);
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
    store_slot(own, slot_thickness, now);
    if constexpr (Law::yields()) store_slot(own, slot_plastic_work, plastic_work);
    const Lanes lever = half * half, shear = half * shear_factor_;
    return {sum.xx * half,       sum.yy * half,       sum.xy * half,  sum.bend_xx * lever,
            sum.bend_yy * lever, sum.bend_xy * lever, sum.zx * shear, sum.yz * shear};
}

/// Forces against the hourglass modes: elastic ones that remember, and viscous ones; counts their work.
ShellHourglass<Lanes> QuadrilateralShells::resist_hourglass(const QuadFrame<Lanes>& f, const ShellHourglass<Lanes>& change, double duration,
                                                            double* own) const
{
    const Lanes thickness = load_slot(own, slot_thickness);
    const GradientSum<Lanes> g = gradient_sum(f);
    const Lanes area_thickness = f.area * thickness, turn_lever = thickness * thickness * (1.0 / 12.0);
    const Lanes stretch = 2.0 * stiffness_.young() * area_thickness * (g.xx + g.yy);
    const Lanes shear = hourglass_.shear * shear_factor_ * stiffness_.shear() * (1.0 / 3.0) * thickness * f.inverse_area;
    const Lanes membrane = hourglass_.membrane * stretch, bending = hourglass_.bending * stretch * turn_lever;
    const double damping = hourglass_.viscosity * std::sqrt(density_ * stiffness_.plane()) / duration;
    const Lanes viscous = damping * thickness * square_root(f.area), viscous_turn = viscous * turn_lever;
    const Lanes stiffnesses[] = {
        membrane, membrane, bending, bending, shear * (f.tx * f.tx + f.ty * f.ty), shear * (f.sx * f.sx + f.sy * f.sy)};
    const Lanes viscosities[] = {viscous, viscous, viscous_turn, viscous_turn, viscous, viscous};
    const Lanes* changes[] = {&change.stretch_x, &change.stretch_y, &change.turn_x, &change.turn_y, &change.shear_s, &change.shear_t};
    Lanes forces[6];
    Lanes spent = load_slot(own, slot_hourglass_work);
    for (int i = 0; i < 6; ++i) {
        const Lanes before = load_slot(own, slot_hourglass + i), rise = stiffnesses[i] * *changes[i], drag = viscosities[i] * *changes[i];
        store_slot(own, slot_hourglass + i, before + rise);
        forces[i] = before + rise + drag;
        spent = spent + (before + 0.5 * rise + drag) * *changes[i];
    }
    store_slot(own, slot_hourglass_work, spent);
    return {forces[0], forces[1], forces[2], forces[3], forces[4], forces[5]};
}

/// 2 / (highest frequency): of plate waves, of bending where the thickness has grown, of transverse shear. [s]
Lanes QuadrilateralShells::transit(const QuadFrame<Lanes>& f, const double* own) const
{
    const Lanes thickness = load_slot(own, slot_thickness), gyration_now = load_slot(own, slot_gyration);
    const GradientSum<Lanes> g = gradient_sum(f);
    const Lanes bending = larger(thickness * thickness / (12.0 * gyration_now), Lanes(1.0));
    const Lanes plate = 4.0 * stiffness_.plane() * membrane_eigenvalue(g, stiffness_.poisson()) * bending;
    const Lanes shear = shear_factor_ * stiffness_.shear() * (4.0 * largest_gradient(g) + 1.0 / gyration_now);
    return 2.0 * square_root(load_slot(own, slot_mass) / (f.area * thickness * larger(plate, shear)));
}

/// Loads on the nodes are opposite to those on the element.
void QuadrilateralShells::write_loads(std::size_t b, const LaneCorners& forces, const LaneCorners& moments,
                                      std::span<CornerLoad> loads) const
{
    alignas(64) double side[6][lane_count];
    const std::size_t first = b * lane_count, lanes = std::min<std::size_t>(lane_count, size_ - first);
    for (int corner = 0; corner < 4; ++corner) {
        const Vector3<Lanes>&f = forces[corner], &m = moments[corner];
        const Lanes* parts[] = {&f.x, &f.y, &f.z, &m.x, &m.y, &m.z};
        for (int i = 0; i < 6; ++i) store_lanes(-*parts[i], side[i]);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            loads[4 * (first + lane) + corner] = {{side[0][lane], side[1][lane], side[2][lane]},
                                                  {side[3][lane], side[4][lane], side[5][lane]}};
    }
}

/// Takes the smallest transit of all blocks; returns the first element that went wrong, or size().
std::size_t QuadrilateralShells::review()
{
    stable_step_ = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < block_count(); ++b) {
        if (!(block_step_[b] > 0)) {
            const std::size_t end = std::min(size_, (b + 1) * lane_count);
            for (std::size_t e = b * lane_count; e < end; ++e)
                if (!std::isfinite(slot(e, slot_work)) || !(slot(e, slot_thickness) > 0)) return e;
            return b * lane_count;
        }
        stable_step_ = std::min(stable_step_, block_step_[b]);
    }
    return size_;
}

PlanePoint<double> QuadrilateralShells::point(std::size_t element, int p) const
{
    const int first = slot_points + p * point_slots_;
    const auto stress_at = [&](int s) {
        return PlaneStress<double>{slot(element, s), slot(element, s + 1), slot(element, s + 2), slot(element, s + 3),
                                   slot(element, s + 4)};
    };
    PlanePoint<double> result;
    result.stress = stress_at(first);
    if (point_slots_ > stress_slots) result.plastic_strain = slot(element, first + stress_slots);
    if (point_slots_ > stress_slots + 1) result.back_stress = stress_at(first + stress_slots + 1);
    return result;
}

ElementValues QuadrilateralShells::values(std::size_t element) const
{
    ElementValues v;
    for (int p = 0; p < point_count(); ++p) {
        const PlanePoint<double> at = point(element, p);
        const double stress = von_mises(at.stress);
        v.von_mises = std::max(v.von_mises, stress);
        v.plastic_strain = std::max(v.plastic_strain, at.plastic_strain);
        if (p == 0) v.von_mises_lower = stress;
        if (p == point_count() / 2) v.von_mises_middle = stress;
        v.von_mises_upper = stress;
    }
    v.thickness = slot(element, slot_thickness);
    return v;
}

ElementEnergy QuadrilateralShells::energy(std::size_t element) const
{
    const double hourglass = slot(element, slot_hourglass_work);
    return {slot(element, slot_work) - hourglass, slot(element, slot_plastic_work), hourglass};
}

std::vector<double> QuadrilateralShells::elementwise() const
{
    std::vector<double> values(size_ * slots_);
    for (std::size_t e = 0; e < size_; ++e)
        for (int s = 0; s < slots_; ++s) values[e * slots_ + s] = slot(e, s);
    return values;
}

void QuadrilateralShells::take_elementwise(std::span<const double> values)
{
    for (std::size_t e = 0; e < corners_.size(); ++e)
        for (int s = 0; s < slots_; ++s)
            block(e / lane_count)[s * lane_count + e % lane_count] = values[std::min(e, size_ - 1) * slots_ + s];
}

std::vector<Field> QuadrilateralShells::state(const std::string& prefix)
{
    Field shells{prefix + "shells", "1", "what each shell keeps", Scalar::float64, 1, size_ * slots_, {}, {}};
    shells.gather = [this](void* out) {
        const std::vector<double> values = elementwise();
        std::copy(values.begin(), values.end(), static_cast<double*>(out));
    };
    shells.restore = [this](const void* in, std::size_t count) {
        if (count != size_ * slots_)
            throw InputError("the saved state has other shells than this model", "resume with the case it was saved from");
        take_elementwise({static_cast<const double*>(in), count});
    };
    Field step{prefix + "shell_step", "s", "smallest transit of an element", Scalar::float64, 1, 1, {}, {}};
    step.gather = [this](void* out) { *static_cast<double*>(out) = stable_step_; };
    step.restore = [this](const void* in, std::size_t) { stable_step_ = *static_cast<const double*>(in); };
    return {std::move(shells), std::move(step)};
}

}  // namespace corpuscle
