#pragma once

#include <functional>
#include <numbers>
#include <string>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/sample.hpp"
#include "laws/riemann/general_riemann.hpp"
#include "laws/riemann/riemann.hpp"

namespace corpuscle {

/// What one-dimensional flow of a gas is at a place.
struct FlowState {
    double density = 0;   ///< [kg/m3]
    double velocity = 0;  ///< [m/s]
    double pressure = 0;  ///< [Pa]

    /// The three, in the order of `flow_names`.
    [[nodiscard]] std::array<double, 3> values() const { return {density, velocity, pressure}; }
};
inline constexpr std::array<const char*, 3> flow_names{"density", "velocity", "pressure"};

/// A tube from x = 0 to 1 m with a membrane that bursts at time 0. One law: the same gas on both sides.
struct TubeCase {
    std::string name;
    std::vector<EquationOfState> laws;  ///< one, or that of the left and that of the right
    FlowState left, right;              ///< density 0: nothing there
    double end_time = 0;                ///< [s]
    double membrane = 0.5;              ///< [m]
    Edge ends = Edge::rigid;            ///< at x = 0 and 1
    double mass_ratio = 1;              ///< of a particle of the second law's gas to one of the first's
    double clear = 1;                   ///< errors count up to here [m]

    [[nodiscard]] double energy(int side) const
    {
        const FlowState& state = side == 0 ? left : right;
        return corpuscle::energy(side == 0 ? laws.front() : laws.back(), state.density, state.pressure);
    }
};

/// The exact solution of a tube: the state on a ray x/t, and the rays of its fronts (shocks, contact, edges of fans and of vacuum).
struct ExactFlow {
    std::function<FlowState(double)> at;
    std::vector<double> fronts;             ///< rising [m/s]
    std::array<double, 2> star_left_edges;  ///< rays between which the left star state is [m/s]
    std::array<double, 2> star_right_edges;
    bool has_star = false;
};

/// A side as the closed solution of ideal and Noble-Abel gases wants it.
inline RiemannSide riemann_side_of(const EquationOfState& law, const FlowState& state)
{
    if (state.density == 0) return {};
    RiemannSide side{state.density, state.velocity, state.pressure, heat_capacity_ratio(law), 0};
    if (const auto* dense = std::get_if<NobleAbel>(&law)) side.co_volume = dense->specific_co_volume();
    return side;
}

/// The flow of a solved Riemann problem.
template <class Solution>
ExactFlow flow_of(const Solution& solution, const TubeCase& tube)
{
    ExactFlow flow;
    flow.at = [solution](double speed) {
        const auto state = solution.at(speed);
        return FlowState{state.density, state.velocity, state.pressure};
    };
    const double contact = solution.star_velocity(), left = solution.left_wave_speed(), right = solution.right_wave_speed();
    flow.has_star = !solution.has_vacuum();
    flow.fronts = {left, contact, right};
    if (!flow.has_star) {
        if (tube.right.density == 0) flow.fronts = {left, contact};
        if (tube.left.density == 0) flow.fronts = {contact, right};
        return flow;
    }
    const double gap = 1e-9 * (right - left);
    const auto before = solution.at(contact - gap), after = solution.at(contact + gap);
    const bool left_fan = before.pressure < tube.left.pressure, right_fan = after.pressure < tube.right.pressure;
    flow.star_left_edges = {left_fan ? before.velocity - before.sound_speed() : left, contact};
    flow.star_right_edges = {contact, right_fan ? after.velocity + after.sound_speed() : right};
    if (left_fan) flow.fronts.insert(flow.fronts.begin() + 1, flow.star_left_edges[0]);
    if (right_fan) flow.fronts.insert(flow.fronts.end() - 1, flow.star_right_edges[1]);
    return flow;
}

/// The exact solution: closed for ideal and Noble-Abel gases, else that of any laws.
inline ExactFlow exact_flow(const TubeCase& tube)
{
    const bool closed =
        std::none_of(tube.laws.begin(), tube.laws.end(), [](const EquationOfState& law) { return std::holds_alternative<Jwl>(law); });
    if (closed) {
        return flow_of(RiemannSolution(riemann_side_of(tube.laws.front(), tube.left), riemann_side_of(tube.laws.back(), tube.right)), tube);
    }
    const auto side = [](const EquationOfState& law, const FlowState& state) {
        return GasSide{law, state.density, state.velocity, state.pressure};
    };
    return flow_of(GeneralRiemannSolution(side(tube.laws.front(), tube.left), side(tube.laws.back(), tube.right)), tube);
}

/// A tube full of particles, so wide that the denser side holds them at the given spacing [m].
inline Gas filled_tube(const TubeCase& tube, double spacing, std::size_t particles, const GasSettings& settings = {})
{
    const double densest = std::max(tube.left.density, tube.right.density);
    const std::vector<double> particle_masses{densest * spacing * spacing * spacing,
                                              densest * spacing * spacing * spacing * tube.mass_ratio};
    const std::vector<double> lengths{tube.membrane, 1 - tube.membrane};
    const std::vector<double> numbers{tube.left.density * lengths[0] / particle_masses[0],
                                      tube.right.density * lengths[1] / particle_masses[1]};
    const double width = std::sqrt(static_cast<double>(particles) / (numbers[0] + numbers[1]));
    Gas gas;
    gas.settings = settings;
    gas.domain.box = {{0, 0, 0}, {1, width, width}};
    gas.domain.edges[0] = gas.domain.edges[1] = tube.ends;
    for (std::size_t s = 0; s < tube.laws.size(); ++s) gas.species.push_back(species_of(tube.laws[s], particle_masses[s]));
    const std::vector<std::size_t> counts = share_particles(numbers, particles);
    const auto last = static_cast<std::uint32_t>(tube.laws.size() - 1);
    const auto fill_side = [&](int side, double from, double to, std::uint32_t species, const FlowState& state) {
        const std::size_t count = counts[static_cast<std::size_t>(side)];
        if (count == 0) return;
        const Shape shape = Shape::box({{from, 0, 0}, {to, width, width}});
        fill(gas, {shape, {}, species, state.density, tube.energy(side), {state.velocity, 0, 0}, -1}, count);
    };
    fill_side(0, 0, tube.membrane, 0, tube.left);
    fill_side(1, tube.membrane, 1, last, tube.right);
    return gas;
}

/// Runs to a time; returns the steps taken.
inline std::uint64_t run_until(Gas& gas, double end_time)
{
    Clock clock;
    while (clock.time() < end_time * (1 - 1e-12)) advance(gas, clock, end_time - clock.time());
    return clock.step();
}

/// The gas between two planes x = const.
struct Slice {
    double lower = 0, upper = 0;  ///< [m]
    double particles = 0;
    FlowState state;
    FlowState sigma;  ///< one standard deviation of the state, from the number of particles

    [[nodiscard]] double middle() const { return 0.5 * (lower + upper); }
};

/// Sums over the particles of a slice, by species.
struct SliceSums {
    std::vector<double> count;
    std::vector<Vector3d> velocity;
    std::vector<double> squared;

    explicit SliceSums(std::size_t species = 0) : count(species), velocity(species), squared(species) {}
};

/// Deviations that a state's noise has: the number of particles fluctuates by sqrt(n chi), chi = p_k/K with K = dp/dln rho at constant
/// temperature (1 in an ideal gas, small in a stiff one), the mean velocity by sqrt(p_k/(rho n)), the temperature by sqrt(2/(3 n)).
inline FlowState noise_of(const EquationOfState& law, double particles, double density, double kinetic)
{
    const auto pressure = [&](double by_density, double by_heat) {
        return kinetic * by_density * by_heat + virial_pressure(law, density * by_density, kinetic * by_density * by_heat);
    };
    constexpr double probe = 1e-3;
    const double stiffness = (pressure(1 + probe, 1) - pressure(1 - probe, 1)) / (2 * probe);
    const double by_heat = (pressure(1, 1 + probe) - pressure(1, 1 - probe)) / (2 * probe);
    const double share = std::min(1.0, kinetic / stiffness);
    return {density * std::sqrt(share / particles), std::sqrt(kinetic / density / particles),
            std::sqrt((share * stiffness * stiffness + 2.0 / 3 * by_heat * by_heat) / particles)};
}

/// State of a slice of known volume from its sums; of n particles seen from their own mean, n - 1 are free to move.
inline void evaluate(Slice& slice, const SliceSums& sums, const Gas& gas, double volume)
{
    double mass = 0;
    Vector3d momentum;
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        slice.particles += sums.count[s];
        mass += gas.species[s].particle_mass * sums.count[s];
        momentum += gas.species[s].particle_mass * sums.velocity[s];
    }
    if (slice.particles == 0) return;
    const Vector3d mean = momentum / mass;
    slice.state = {mass / volume, mean.x, 0};
    const double bias = slice.particles / std::max(1.0, slice.particles - 1);
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        if (sums.count[s] == 0) continue;
        const double own_mass = gas.species[s].particle_mass, own_density = own_mass * sums.count[s] / volume;
        const double squared = sums.squared[s] - 2 * dot(mean, sums.velocity[s]) + sums.count[s] * norm_squared(mean);
        const double kinetic = bias * own_mass * squared / (3 * volume);
        slice.state.pressure += kinetic + virial_pressure(gas.species[s].law, own_density, kinetic);
        const FlowState own = noise_of(gas.species[s].law, sums.count[s], own_density, kinetic);
        slice.sigma.density = std::hypot(slice.sigma.density, own.density);
        slice.sigma.pressure = std::hypot(slice.sigma.pressure, own.pressure);
        slice.sigma.velocity = std::hypot(slice.sigma.velocity, own.velocity * own_density / slice.state.density);
    }
}

/// Cuts the gas into slices at the given places (rising) [m].
inline std::vector<Slice> slices(const Gas& gas, const std::vector<double>& edges)
{
    std::vector<SliceSums> sums(edges.size() - 1, SliceSums(gas.species.size()));
    for (const Particle& particle : gas.particles) {
        if (particle.tag & (particle_tag::gone | particle_tag::unburnt)) continue;
        const auto after = std::upper_bound(edges.begin(), edges.end(), static_cast<double>(particle.position.x));
        if (after == edges.begin() || after == edges.end()) continue;
        SliceSums& own = sums[static_cast<std::size_t>(after - edges.begin()) - 1];
        const std::uint32_t s = particle_tag::species(particle.tag);
        const Vector3d velocity(particle.velocity);
        own.count[s] += 1;
        own.velocity[s] += velocity;
        own.squared[s] += norm_squared(velocity);
    }
    const Vector3d size = gas.domain.box.size();
    std::vector<Slice> result(sums.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i].lower = edges[i];
        result[i].upper = edges[i + 1];
        evaluate(result[i], sums[i], gas, (edges[i + 1] - edges[i]) * size.y * size.z);
    }
    return result;
}

/// Mean of neighbouring slices [first, end): of density and pressure over space, of velocity over mass. Measured in thin slices and then
/// averaged, so that the slope of the velocity in a bin is not taken for heat.
inline Slice merged(const std::vector<Slice>& all, std::size_t first, std::size_t end)
{
    Slice bin;
    bin.lower = all[first].lower;
    bin.upper = all[end - 1].upper;
    double mass = 0, momentum = 0, momentum_noise = 0;
    for (std::size_t i = first; i < end; ++i) {
        const double share = (all[i].upper - all[i].lower) / (bin.upper - bin.lower);
        const FlowState &state = all[i].state, &sigma = all[i].sigma;
        bin.particles += all[i].particles;
        mass += share * state.density;
        momentum += share * state.density * state.velocity;
        momentum_noise = std::hypot(momentum_noise, share * state.density * sigma.velocity);
        bin.state.pressure += share * state.pressure;
        bin.sigma.density = std::hypot(bin.sigma.density, share * sigma.density);
        bin.sigma.pressure = std::hypot(bin.sigma.pressure, share * sigma.pressure);
    }
    bin.state.density = mass;
    bin.state.velocity = mass > 0 ? momentum / mass : 0;
    bin.sigma.velocity = mass > 0 ? momentum_noise / mass : 0;
    return bin;
}

/// Exact mean between two planes, taken as `merged` takes it.
inline FlowState exact_mean(const TubeCase& tube, const ExactFlow& flow, double lower, double upper)
{
    constexpr int points = 64;
    FlowState mean;
    double momentum = 0;
    for (int k = 0; k < points; ++k) {
        const FlowState at = flow.at((lower + (upper - lower) * (k + 0.5) / points - tube.membrane) / tube.end_time);
        mean.density += at.density / points;
        mean.pressure += at.pressure / points;
        momentum += at.density * at.velocity / points;
    }
    mean.velocity = mean.density > 0 ? momentum / mean.density : 0;
    return mean;
}

/// Edges from 0 to 1 at every exact front and evenly between them, no further apart than `longest`: a front that stands between two
/// bins shows its whole smear, for the error has one sign on either side of it.
inline std::vector<double> edges_at_fronts(const TubeCase& tube, const ExactFlow& flow, double longest)
{
    std::vector<double> marks{0, 1};
    for (const double ray : flow.fronts) {
        const double place = tube.membrane + ray * tube.end_time;
        if (place > 0 && place < 1) marks.push_back(place);
    }
    std::sort(marks.begin(), marks.end());
    std::vector<double> edges{0};
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        const double length = marks[i + 1] - marks[i];
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / longest)));
        for (int k = 1; k <= pieces; ++k) edges.push_back(marks[i] + length * k / pieces);
    }
    return edges;
}

/// Mean absolute error over the tube of density, velocity and pressure. Velocity counts where the exact density is
/// at least a twentieth of the largest: at an edge to vacuum the gas thins out within a mean free path, and Euler's equations end.
struct TubeErrors {
    std::array<double, 3> sum{};
    std::array<double, 3> noise{};    ///< at most this part of it is from the finite number of particles
    std::array<double, 3> scatter{};  ///< standard deviation of it

    /// Takes up a bin that fills a part of the tube: its absolute error and that of the particles in it, sqrt(2/pi) sigma.
    void add(const Slice& bin, const FlowState& exact, double part, double largest_density)
    {
        for (int q = 0; q < 3; ++q) {
            if (q == 1 && exact.density < 0.05 * largest_density) continue;
            const double sigma = bin.sigma.values()[q];
            sum[q] += part * std::abs(bin.state.values()[q] - exact.values()[q]);
            noise[q] += part * std::sqrt(2 / std::numbers::pi) * sigma;
            scatter[q] = std::hypot(scatter[q], part * sigma);
        }
    }
    /// Lower bound of what is not noise.
    [[nodiscard]] double rest(int q) const { return sum[q] - noise[q]; }
};

/// Bins of at most 1/20 m at the fronts, each the mean of five thin slices; empty ones are none.
inline std::vector<Slice> tube_bins(const Gas& gas, const TubeCase& tube, const ExactFlow& flow, double longest = 0.05)
{
    constexpr int thin = 5;
    const std::vector<double> edges = edges_at_fronts(tube, flow, longest);
    std::vector<double> fine{edges.front()};
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        for (int k = 1; k <= thin; ++k) fine.push_back(edges[i] + (edges[i + 1] - edges[i]) * k / thin);
    }
    const std::vector<Slice> all = slices(gas, fine);
    std::vector<Slice> bins;
    for (std::size_t i = 0; i + thin <= all.size(); i += thin) bins.push_back(merged(all, i, i + thin));
    return bins;
}

/// The errors of a tube at its end time.
inline TubeErrors tube_errors(const Gas& gas, const TubeCase& tube, const ExactFlow& flow)
{
    TubeErrors errors;
    const double largest = std::max(tube.left.density, tube.right.density);
    for (const Slice& bin : tube_bins(gas, tube, flow)) {
        if (bin.upper > tube.clear) continue;
        errors.add(bin, exact_mean(tube, flow, bin.lower, bin.upper), bin.upper - bin.lower, largest);
    }
    return errors;
}

/// Errors of another flow against the exact one, in the bins of `tube_errors`.
inline TubeErrors errors_between(const TubeCase& tube, const ExactFlow& exact, const ExactFlow& other)
{
    TubeErrors errors;
    const std::vector<double> edges = edges_at_fronts(tube, exact, 0.05);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        Slice bin;
        bin.state = exact_mean(tube, other, edges[i], edges[i + 1]);
        errors.add(bin, exact_mean(tube, exact, edges[i], edges[i + 1]), edges[i + 1] - edges[i],
                   std::max(tube.left.density, tube.right.density));
    }
    return errors;
}

/// The mean state of a star region, of its middle half: clear of the waves on both sides.
inline Slice star_state(const Gas& gas, const TubeCase& tube, const std::array<double, 2>& rays)
{
    constexpr int thin = 5;
    const double low = tube.membrane + rays[0] * tube.end_time, length = (rays[1] - rays[0]) * tube.end_time;
    std::vector<double> edges;
    for (int k = 0; k <= thin; ++k) edges.push_back(low + length * (0.25 + 0.5 * k / thin));
    return merged(slices(gas, edges), 0, thin);
}

/// Kinematic viscosity that theory gives this gas in a state: hard spheres of mean free path lambda = kappa s/Z (s the spacing, Z = p/p_k
/// the Enskog factor), 5 pi/32 c lambda with c the mean speed (Chapman & Enskog), times 1 + 16/(45 pi) (L/lambda)^2 for partners up to a
/// cell's side L apart (Alexander, Garcia & Alder, Phys. Fluids 10 (1998) 1540). Cells are taken as full: a bound. [m2/s]
inline double viscosity_bound(const Gas& gas, std::size_t species, const FlowState& state)
{
    const Species& own = gas.species[species];
    const double spacing = std::cbrt(own.particle_mass / state.density);
    const double heat = energy(own.law, state.density, state.pressure) * (heat_capacity_ratio(own.law) - 1);
    const double enskog = state.pressure / (state.density * heat);
    const double path = gas.settings.mean_free_path * spacing / enskog;
    const double side = spacing * std::cbrt(enskog > 1.1 ? gas.settings.group_limit : gas.settings.cell_limit);
    const double mean_speed = std::sqrt(8 / std::numbers::pi * heat);
    return 5 * std::numbers::pi / 32 * mean_speed * (path + 16 / (45 * std::numbers::pi) * side * side / path);
}

/// How far viscosity and conduction spread what Euler's equations keep sharp, as the standard deviation of a Gauss curve [m]: a wave by its
/// sound diffusivity, sqrt((4/3 nu + bulk + (gamma - 1) chi) t), a contact by that of heat, sqrt(2 chi t), chi = nu/Pr at most 1.5 nu:
/// neither more than sqrt(3 nu t). The largest of the states in the tube.
inline double spread(const Gas& gas, const TubeCase& tube, const ExactFlow& flow)
{
    double viscosity = 0;
    const auto take = [&](std::size_t species, const FlowState& state) {
        if (state.density > 0) viscosity = std::max(viscosity, viscosity_bound(gas, species, state));
    };
    const std::size_t last = gas.species.size() - 1;
    take(0, tube.left);
    take(last, tube.right);
    if (flow.has_star) {
        take(0, flow.at(0.5 * (flow.star_left_edges[0] + flow.star_left_edges[1])));
        take(last, flow.at(0.5 * (flow.star_right_edges[0] + flow.star_right_edges[1])));
    } else {
        viscosity *= 2;  // in a fan c s rises as density^(-0.13): twofold at a density of 0.005
    }
    return std::sqrt(3 * viscosity * tube.end_time);
}

/// The exact flow, its fronts spread by a Gauss curve of this standard deviation [m] at the tube's end time.
inline ExactFlow spread_flow(const TubeCase& tube, const ExactFlow& flow, double deviation)
{
    ExactFlow result = flow;
    const double width = deviation / tube.end_time;
    result.at = [flow, width](double ray) {
        constexpr int points = 81;
        FlowState mean;
        double total = 0;
        for (int k = 0; k < points; ++k) {
            const double z = 8.0 * k / (points - 1) - 4, weight = std::exp(-0.5 * z * z);
            const FlowState at = flow.at(ray + z * width);
            total += weight;
            mean.density += weight * at.density;
            mean.velocity += weight * at.velocity;
            mean.pressure += weight * at.pressure;
        }
        return FlowState{mean.density / total, mean.velocity / total, mean.pressure / total};
    };
    return result;
}

/// Sod's tube (J. Comput. Phys. 27 (1978) 1).
inline TubeCase sod_tube()
{
    return {"Sod", {IdealGas{1.4}}, {1, 0, 1}, {0.125, 0, 0.1}, 0.2};
}

/// Gas that streams into a rigid wall: one shock and no contact, beside what the first moments leave at the wall. Errors count up to where
/// the fan from the other end, which the gas leaves, has not come.
inline TubeCase stream_tube()
{
    TubeCase tube{"stream into a wall", {IdealGas{1.4}}, {1, 1, 1}, {1, -1, 1}, 0.3};
    tube.membrane = 0;
    tube.clear = 0.34;
    return tube;
}

/// Pressure ratio 1e5: the left half of Woodward and Colella's blast waves (J. Comput. Phys. 54 (1984) 115).
inline TubeCase strong_shock_tube()
{
    return {"pressure ratio 1e5", {IdealGas{1.4}}, {1, 0, 1000}, {1, 0, 0.01}, 0.012};
}

/// Sod's states in a gas whose molecules fill a given share of the left half.
inline TubeCase noble_abel_tube(double gamma, double filled)
{
    const double right_density = 0.125 / (1 - filled + 0.125 * filled);  // Sod's ratio of free volumes
    return {"Noble-Abel, gamma " + std::to_string(gamma).substr(0, 4) + ", filled " + std::to_string(filled).substr(0, 3),
            {NobleAbel{gamma, filled, 1}},
            {1, 0, 1},
            {right_density, 0, 0.1},
            0.2 * (1 - 0.7 * filled)};
}

/// A gas against nothing.
inline TubeCase vacuum_tube(const EquationOfState& law)
{
    return {"into vacuum", {law}, {1, 0, 1}, {}, 0.1, 0.4};
}

/// A gas torn apart at its middle; beyond 2 c/(gamma - 1) (3.74 here) nothing is left there. The ends are open: the gas leaves them faster
/// than sound.
inline TubeCase torn_tube(double speed)
{
    return {"torn apart at " + std::to_string(speed).substr(0, 3),
            {IdealGas{1.4}},
            {1, -speed, 0.4},
            {1, speed, 0.4},
            0.3 / speed,
            0.5,
            Edge::open};
}

/// The products of TNT, all burnt at constant volume, against air. Their densities differ a thousandfold: particles of one mass would be
/// ten times further apart in the air than in the products, so those of the air are lighter.
inline TubeCase tnt_tube(double mass_ratio)
{
    const Jwl products{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
    TubeCase tube{"TNT against air", {products, IdealGas{1.4}}, {1630, 0, 0}, {1.2, 0, 101325}, 6e-5, 0.45};
    tube.left.pressure = products.pressure(1630, 7e9 / 1630);
    tube.mass_ratio = mass_ratio;
    return tube;
}

}  // namespace corpuscle
