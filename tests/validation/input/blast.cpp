/// TNT in free air: what arrives where. One JSON object a line.
///
///     validate_blast radial CELLS FARTHEST
///         1 kg in one dimension: arrival, first peak and impulse at the distances up to FARTHEST
///     validate_blast seen CELLS FARTHEST
///         the same, read as the particles are: in shells, averaged over as long
///     validate_blast particles N SEED NEAREST FARTHEST START KAPPA CELL CFL
///         an octant of N particles, at the distances between; START: the time [s] its particles are laid out at from the solution in one
///         dimension, 0: lit as they are; mean free path, most in a cell, step
///     validate_blast front_radial CELLS SPEED
///         15 kg: the state at 0.1 and 0.2 ms; SPEED of detonation [m/s], 0: burnt at once
///     validate_blast front_particles N SEED START GROUP
///         the same from an octant of N particles; GROUP: most in a group
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "gas/burn.hpp"
#include "gas/collide.hpp"
#include "gas/fill.hpp"
#include "gas/fly.hpp"
#include "gas/radial_fill.hpp"
#include "gas/sleep.hpp"
#include "gas/sort.hpp"
#include "laws/blast/kingery_bulmash.hpp"
#include "radial/charge.hpp"
#include "radial/gauge.hpp"

using namespace corpuscle;

namespace {

constexpr double explosive_density = 1630, explosive_energy = 7e9 / explosive_density, detonation_velocity = 6930;
constexpr double air_density = 1.2, air_energy = 0.253e6 / air_density, air_pressure = 0.4 * 0.253e6;
constexpr std::array<double, 8> distances{0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3};
const Jwl products{371.2e9, 3.231e9, 4.15, 0.95, 0.3, explosive_density};

/// What has passed after this scaled time is measured: arrival and positive phase at a distance [s].
double enough(double distance)
{
    return 1e-3 * (0.6 + 1.7 * distance + 0.2 * distance * distance);
}

RadialCharge charge_of(double mass, double speed)
{
    return {products,      explosive_density, explosive_energy, speed, ball_radius(mass, explosive_density),
            IdealGas{1.4}, air_density,       air_pressure};
}

void print_measures(double distance, const BlastMeasures& measures)
{
    const BlastWave empirical = kingery_bulmash(Burst::spherical, 1, distance);
    std::printf(
        "\"distance\": %g, \"arrival_ms\": %.6g, \"peak_kpa\": %.6g, \"impulse_pa_s\": %.6g, \"duration_ms\": %.6g, \"complete\": %s, "
        "\"kb\": {\"arrival_ms\": %.6g, \"peak_kpa\": %.6g, \"impulse_pa_s\": %.6g}}\n",
        distance, 1e3 * measures.arrival, 1e-3 * measures.overpressure, measures.impulse, 1e3 * measures.duration,
        measures.complete ? "true" : "false", 1e3 * empirical.arrival, 1e-3 * empirical.incident_pressure, empirical.incident_impulse);
    std::fflush(stdout);
}

void radial(double cells, double farthest)
{
    RadialFlow flow = lay_charge(charge_of(1, detonation_velocity), {cells, 30, 0.25}, 1.6 * farthest + 0.3);
    std::vector<RadialGauge> gauges;
    for (const double distance : distances)
        if (distance <= farthest) gauges.push_back({distance, {}});
    flow.run(enough(farthest), [&](const RadialFlow& now) {
        for (RadialGauge& gauge : gauges) gauge.record(now);
    });
    for (const RadialGauge& gauge : gauges) {
        std::printf("{\"kind\": \"radial\", \"cells\": %g, ", cells);
        print_measures(gauge.radius, measure_blast(gauge.samples, air_pressure, 1e3));
    }
}

/// An octant of a ball of TNT in a cube of air.
struct Octant {
    Gas gas;
    Clock clock;
    double front = 0;  ///< of the flow that it was laid out from [m]

    Octant(double mass, double side, std::size_t count, const GasSettings& settings, double start)
    {
        gas.settings = settings;
        gas.domain = {Box{{0, 0, 0}, {side, side, side}},
                      {Edge::rigid, Edge::ambient, Edge::rigid, Edge::ambient, Edge::rigid, Edge::ambient}};
        const RadialCharge charge = charge_of(mass, detonation_velocity);
        const Shape ball = Shape::sphere({0, 0, 0}, charge.radius);
        const double charge_mass = mass / 8, air_mass = air_density * (gas.domain.box.volume() - ball.volume_within(gas.domain.box));
        const std::vector<std::size_t> counts = share_particles({air_mass, charge_mass}, count);
        gas.species = {{"air", IdealGas{1.4}, air_mass / static_cast<double>(counts[0]), internal_freedoms(1.4)},
                       {"tnt", products, charge_mass / static_cast<double>(counts[1]), internal_freedoms(1.3)}};
        gas.ambient = {0, air_density, air_pressure, 0.4 * air_energy};
        if (start > 0) {
            lay_out(charge, counts, start);
        } else {
            gas.charges.push_back({"tnt", 1, detonation_velocity, explosive_energy, explosive_density, {{{0, 0, 0}, 0}}, 0});
            fill(gas, {Shape::box(gas.domain.box), {ball}, 0, air_density, air_energy, {}, -1}, counts[0]);
            fill(gas, {ball, {}, 1, explosive_density, explosive_energy, {}, 0}, counts[1]);
        }
        gas.sleeping.disturbances.push_back({{{0, 0, 0}, Vector3d(1, 1, 1) * std::max(front, charge.radius)}, 0});
        lay_to_sleep(gas, FacetTree{Surface{}});
        sort(gas);
        survey(gas);
    }

    /// Particles from the flow in one dimension at a time; air beyond it lies still.
    void lay_out(const RadialCharge& charge, const std::vector<std::size_t>& counts, double start)
    {
        RadialFlow flow = lay_charge(charge, {100, 30, 0.25}, gas.domain.box.size().x);
        flow.run(start);
        std::array<RadialFill, 2> fills;
        const double all = whole(Symmetry::spherical);
        for (std::size_t i = 0; i < flow.disturbed(); ++i) {
            const double low = flow.velocities()[i], high = flow.velocities()[i + 1], mass = all * flow.masses()[i];
            RadialFill& fill = fills[flow.gas(i)];
            fill.layers.push_back({flow.edges()[i], flow.edges()[i + 1], flow.densities()[i], flow.energies()[i], low, high});
            fill.mass += mass;
            fill.momentum += 0.5 * mass * (low + high);
            fill.energy += mass * (flow.energies()[i] + 0.25 * (low * low + high * high));
        }
        // Air up to a radius that holds whole particles.
        const double particle_mass = 8 * gas.species[0].particle_mass;
        const double inside = std::ceil(fills[1].mass / particle_mass), added = inside * particle_mass - fills[1].mass;
        const double edge = flow.edges()[flow.disturbed()], outer = std::cbrt(edge * edge * edge + 3 * added / (all * air_density));
        fills[1].layers.push_back({edge, outer, air_density, air_energy, 0, 0});
        fills[1].mass += added;
        fills[1].energy += added * air_energy;
        fills[0].species = 1;
        front = edge;
        const auto count = static_cast<std::size_t>(inside);
        fill(gas, {Shape::box(gas.domain.box), {Shape::sphere({0, 0, 0}, outer)}, 0, air_density, air_energy, {}, -1}, counts[0] - count);
        fill_radial(gas, fills[1], count);
        fill_radial(gas, fills[0], counts[1]);
        clock.restore(start, 0, 0, 0);
    }

    void step(double end)
    {
        const FacetTree none{Surface{}};
        clock.begin_step(std::min(end - clock.time(), stable_step(gas, clock.time())));
        burn(gas, clock);
        wake(gas, clock);
        sort(gas);
        collide(gas, clock, none);
        fly(gas, clock, none);
        clock.end_step();
    }
};

/// Sums over the gas between two radii.
struct Shell {
    double mass = 0, outward = 0, energy = 0;  ///< energy: m v^2 of all motion

    [[nodiscard]] RadialSample sample(double time, double volume) const
    {
        const double bulk = mass > 0 ? outward * outward / mass : 0;
        return {time, (energy - bulk) / (3 * volume), mass / volume, mass > 0 ? outward / mass : 0};
    }
};
constexpr double half_width = 0.04;  ///< of a shell, in its radius

double octant_between(double inner, double outer)
{
    return std::numbers::pi / 6 * (outer * outer * outer - inner * inner * inner);
}

/// Pressure in thin shells around the distances: of the particles' motion against that of the shell as a whole; the products are so thin
/// there that they have no other.
std::vector<RadialSample> shells(const Gas& gas, double time, const std::vector<double>& radii)
{
    std::vector<Shell> sums(radii.size());
    for (const Particle& p : gas.particles) {
        if (p.tag & particle_tag::gone) continue;
        const Vector3d place(p.position), velocity(p.velocity);
        const double r = norm(place), mass = gas.species[particle_tag::species(p.tag)].particle_mass;
        for (std::size_t k = 0; k < radii.size(); ++k) {
            if (std::abs(r - radii[k]) > half_width * radii[k]) continue;
            const double outward = dot(velocity, place) / r;
            sums[k].mass += mass;
            sums[k].outward += mass * outward;
            sums[k].energy += mass * norm_squared(velocity);
        }
    }
    std::vector<RadialSample> samples;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        samples.push_back(sums[k].sample(time, octant_between((1 - half_width) * radii[k], (1 + half_width) * radii[k])));
    }
    return samples;
}

/// Means over some samples that follow each other, so that noise makes no peaks: over about a fiftieth of the time of arrival.
std::vector<RadialSample> smoothed(const std::vector<RadialSample>& samples, double window)
{
    std::vector<RadialSample> means;
    std::size_t begin = 0, end = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        while (samples[begin].time < samples[i].time - 0.5 * window) ++begin;
        while (end < samples.size() && samples[end].time <= samples[i].time + 0.5 * window) ++end;
        RadialSample mean{samples[i].time};
        for (std::size_t k = begin; k < end; ++k) mean.pressure += samples[k].pressure / static_cast<double>(end - begin);
        means.push_back(mean);
    }
    return means;
}

/// Records of shells around the distances in a range, taken now and then, and what is read off them.
class ShellRecords {
public:
    ShellRecords(double nearest, double farthest) : every_(2e-6 * nearest / 0.2)
    {
        for (const double distance : distances)
            if (distance >= nearest && distance <= farthest) radii_.push_back(distance);
        records_.resize(radii_.size());
    }

    template <class Sample>
    void take(double time, const Sample& sample)
    {
        if (time < due_) return;
        due_ = time + every_;
        const std::vector<RadialSample> now = sample(radii_);
        for (std::size_t k = 0; k < radii_.size(); ++k) records_[k].push_back(now[k]);
    }

    void print(const std::string& head) const
    {
        for (std::size_t k = 0; k < radii_.size(); ++k) {
            const double window = 0.03e-3 * std::pow(radii_[k], 1.5);
            const double noise = 0.2 * kingery_bulmash(Burst::spherical, 1, radii_[k]).incident_pressure;
            std::printf("{%s, ", head.c_str());
            print_measures(radii_[k], measure_blast(smoothed(records_[k], window), air_pressure, noise));
        }
    }

private:
    double every_, due_ = 0;
    std::vector<double> radii_;
    std::vector<std::vector<RadialSample>> records_;
};

void particles(std::size_t count, double nearest, double farthest, double start, const GasSettings& settings)
{
    Octant octant(1, 1.35 * farthest, count, settings, start);
    ShellRecords records(nearest, farthest);
    const double end = enough(farthest);
    double work = 0, all = 0;
    while (octant.clock.time() < end * (1 - 1e-12)) {
        octant.step(end);
        work += static_cast<double>(octant.gas.particles.size() - octant.gas.sleeping.particles);
        all += static_cast<double>(octant.gas.particles.size());
        records.take(octant.clock.time(), [&](const auto& radii) { return shells(octant.gas, octant.clock.time(), radii); });
    }
    const double steps = static_cast<double>(octant.clock.step()), awake = work / all;
    const double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    records.print(
        fmt::format("\"kind\": \"particles\", \"particles\": {}, \"seed\": {}, \"start_ms\": {:g}, \"kappa\": {:g}, \"cell\": {}, "
                    "\"cfl\": {:g}, \"steps\": {:.0f}, \"awake\": {:.3f}, \"cpu_s\": {:.1f}",
                    count, settings.seed, 1e3 * start, settings.mean_free_path, settings.cell_limit, settings.cfl, steps, awake, cpu));
}

/// The flow's cells in the shells, each cell cut where a shell ends; motion of a cell is that of its middle.
std::vector<RadialSample> shells(const RadialFlow& flow, double time, const std::vector<double>& radii)
{
    std::vector<RadialSample> samples;
    for (const double radius : radii) {
        const double inner = (1 - half_width) * radius, outer = (1 + half_width) * radius;
        Shell sum;
        for (std::size_t i = 0; i < flow.cells(); ++i) {
            const double from = std::max(inner, flow.edges()[i]), to = std::min(outer, flow.edges()[i + 1]);
            if (!(to > from)) continue;
            const double volume = octant_between(from, to), mass = flow.densities()[i] * volume;
            const double velocity = 0.5 * (flow.velocities()[i] + flow.velocities()[i + 1]);
            sum.mass += mass;
            sum.outward += mass * velocity;
            sum.energy += mass * velocity * velocity + 3 * flow.pressures()[i] * volume;
        }
        samples.push_back(sum.sample(time, octant_between(inner, outer)));
    }
    return samples;
}

void seen(double cells, double farthest)
{
    RadialFlow flow = lay_charge(charge_of(1, detonation_velocity), {cells, 30, 0.25}, 1.6 * farthest + 0.3);
    ShellRecords records(distances.front(), farthest);
    flow.run(enough(farthest),
             [&](const RadialFlow& now) { records.take(now.time(), [&](const auto& radii) { return shells(now, now.time(), radii); }); });
    records.print(fmt::format("\"kind\": \"seen\", \"cells\": {:g}", cells));
}

constexpr std::array<double, 2> front_times{1e-4, 2e-4};
constexpr double shell_width = 0.02;
constexpr std::size_t shell_count = 50;
using Densities = std::array<std::array<double, shell_count>, 2>;  ///< of air and products in shells of 2 cm [kg/m3]

double shell_volume(std::size_t k)
{
    const double inner = shell_width * static_cast<double>(k), outer = inner + shell_width;
    return std::numbers::pi / 6 * (outer * outer * outer - inner * inner * inner);
}

/// Radius where the density, coming from outside, is half way from still air to the air's peak; between the shells' middles.
double half_rise(const Densities& density)
{
    const auto all = [&](std::size_t k) { return density[0][k] + density[1][k]; };
    const double half = 0.5 * (air_density + *std::max_element(density[0].begin(), density[0].end()));
    std::size_t k = shell_count - 2;
    while (k > 0 && all(k) < half) --k;
    return (static_cast<double>(k) + 0.5 + (all(k) - half) / (all(k) - all(k + 1))) * shell_width;
}

/// Radius within which there is as much mass of products as of air within shells further out: where the two change places.
double face_radius(const Densities& density)
{
    std::size_t k = shell_count - 1;
    while (k > 0 && density[1][k] < density[0][k]) --k;
    const double here = density[1][k] - density[0][k], next = density[1][k + 1] - density[0][k + 1];
    return (static_cast<double>(k) + 0.5 + here / (here - next)) * shell_width;
}

void print_front(double time, const Densities& density, double products_momentum, double air_momentum)
{
    std::printf("\"time_ms\": %g, \"half_rise\": %.4f, \"face\": %.4f, \"products_momentum\": %.5g, \"air_momentum\": %.5g}\n", 1e3 * time,
                half_rise(density), face_radius(density), products_momentum, air_momentum);
    std::fflush(stdout);
}

void front_radial(double cells, double speed)
{
    RadialFlow flow = lay_charge(charge_of(15, speed), {cells, 30, 0.5}, 1.3);
    for (const double time : front_times) {
        flow.run(time);
        Densities density{};
        for (std::size_t i = 0; i < flow.cells(); ++i) {
            constexpr int pieces = 20;
            const double inner = flow.edges()[i], width = (flow.edges()[i + 1] - inner) / pieces;
            for (int piece = 0; piece < pieces; ++piece) {
                const double from = inner + piece * width;
                const auto k = static_cast<std::size_t>((from + 0.5 * width) / shell_width);
                if (k >= shell_count) continue;
                const double mass = std::numbers::pi / 2 * flow.densities()[i] * volume_between(Symmetry::spherical, from, from + width);
                density[flow.gas(i) == 0 ? 1 : 0][k] += mass / shell_volume(k);
            }
        }
        const double octant = whole(Symmetry::spherical) / 8;
        std::printf("{\"kind\": \"front_radial\", \"cells\": %g, \"speed\": %g, ", cells, speed);
        print_front(time, density, octant * flow.contents(0).momentum, octant * flow.contents(1).momentum);
    }
}

void front_particles(std::size_t count, std::uint64_t seed, double start, std::uint32_t group)
{
    Octant octant(15, 1, count, {.seed = seed, .group_limit = group}, start);
    for (const double time : front_times) {
        if (time <= start) continue;
        while (octant.clock.time() < time * (1 - 1e-12)) octant.step(time);
        Densities density{};
        std::array<double, 2> momentum{};
        for (const Particle& p : octant.gas.particles) {
            if (p.tag & particle_tag::gone) continue;
            const std::uint32_t species = particle_tag::species(p.tag);
            const double r = norm(Vector3d(p.position)), mass = octant.gas.species[species].particle_mass;
            const auto k = static_cast<std::size_t>(r / shell_width);
            momentum[species] += mass * dot(Vector3d(p.velocity), Vector3d(p.position)) / r;
            if (k < shell_count) density[species][k] += mass / shell_volume(k);
        }
        std::printf("{\"kind\": \"front_particles\", \"particles\": %zu, \"seed\": %d, \"start_ms\": %g, \"group\": %u, ", count,
                    static_cast<int>(seed), 1e3 * start, group);
        print_front(time, density, momentum[1], momentum[0]);
    }
}

}  // namespace

int main(int count, char** words)
{
    const auto number = [&](int i) { return i < count ? std::atof(words[i]) : 0.0; };
    const auto whole_number = [&](int i) { return static_cast<std::uint64_t>(number(i)); };
    const std::string what = count > 1 ? words[1] : "";
    if (what == "radial") {
        radial(number(2), number(3));
    } else if (what == "particles") {
        const auto cell = static_cast<std::uint32_t>(number(8));
        particles(whole_number(2), number(4), number(5), number(6),
                  {.seed = whole_number(3), .cell_limit = cell, .mean_free_path = number(7), .cfl = number(9)});
    } else if (what == "seen") {
        seen(number(2), number(3));
    } else if (what == "front_radial") {
        front_radial(number(2), number(3));
    } else if (what == "front_particles") {
        front_particles(whole_number(2), whole_number(3), number(4), static_cast<std::uint32_t>(number(5)));
    } else {
        std::fprintf(stderr, "expected: radial, seen, particles, front_radial or front_particles, with their numbers\n");
        return 2;
    }
    return 0;
}
