/// A layer of hot TNT products bursts into air and strikes a rigid wall: what the wall feels. One JSON object a line.
///
///     validate_wall exact CELLS                                      in one dimension
///     validate_wall particles N LAYERS KAPPA CELL CFL SEED           by N particles, LAYERS of them across the products at the start;
///                                                                    KAPPA: mean free path in spacings; CELL: most in a cell; CFL
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "gas/collide.hpp"
#include "gas/fill.hpp"
#include "gas/fly.hpp"
#include "gas/sleep.hpp"
#include "gas/sort.hpp"
#include "math/random.hpp"
#include "radial/flow.hpp"
#include "radial/zoning.hpp"

using namespace corpuscle;

namespace {

constexpr double explosive_density = 1630, explosive_energy = 7e9 / explosive_density;
constexpr double air_density = 1.2, air_energy = 0.253e6 / air_density, air_pressure = 0.4 * 0.253e6;
constexpr double layer = 0.002, wall = 0.35;          ///< thickness of the products, place of the wall [m]
constexpr double end_time = 0.3e-3, interval = 2e-6;  ///< [s]
const Jwl products{371.2e9, 3.231e9, 4.15, 0.95, 0.3, explosive_density};

/// Pressure on the wall, averaged over intervals of time.
class WallRecord {
public:
    /// Adds an impulse on a square metre [Pa s] that came between two times [s].
    void add(double from, double to, double impulse)
    {
        const auto at = static_cast<std::size_t>(0.5 * (from + to) / interval);
        if (at < pressure_.size()) pressure_[at] += impulse / interval;
    }

    /// Arrival, when half of the peak is reached, peak, and impulse over the ambient pressure, until the end.
    void print(double cpu_seconds, double steps) const
    {
        double peak = 0, impulse = 0, arrival = 0;
        for (const double p : pressure_) {
            peak = std::max(peak, p);
            impulse += (p - air_pressure) * interval;
        }
        for (std::size_t k = 1; k < pressure_.size() && arrival == 0; ++k) {
            const double before = pressure_[k - 1], now = pressure_[k];
            if (now >= 0.5 * peak) arrival = (static_cast<double>(k) - 0.5 + (0.5 * peak - before) / (now - before)) * interval;
        }
        std::printf("\"arrival_ms\": %.5g, \"peak_mpa\": %.5g, \"impulse_kpa_s\": %.5g, \"cpu_s\": %.3g, \"steps\": %g}\n", 1e3 * arrival,
                    1e-6 * peak, 1e-3 * impulse, cpu_seconds, steps);
    }

private:
    std::vector<double> pressure_ = std::vector<double>(static_cast<std::size_t>(std::lround(end_time / interval)), 0.0);
};

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<double> equal_edges(double from, double to, std::size_t cells)
{
    std::vector<double> edges;
    for (std::size_t k = 0; k <= cells; ++k) edges.push_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(cells));
    return edges;
}

void exact(std::size_t cells)
{
    RadialZone hot{equal_edges(0, layer, cells), products, explosive_density, explosive_energy, 0, 0};
    RadialZone air{equal_edges(layer, wall, 2 * cells), IdealGas{1.4}, air_density, air_energy, 0, 0};
    RadialFlow flow(Symmetry::planar, {hot, air});
    WallRecord record;
    double before = 0;
    int steps = 0;
    flow.run(end_time, [&](const RadialFlow& now) {
        record.add(before, now.time(), now.pressures().back() * (now.time() - before));
        before = now.time();
        ++steps;
    });
    std::printf("{\"kind\": \"exact\", \"cells\": %zu, ", cells);
    record.print(cpu_seconds(), steps);
}

/// A run of particles, as the words of the command say.
struct Wanted {
    std::size_t count = 0;
    double layers = 0;  ///< of particles across the products
    GasSettings settings;
    bool quiet = true, sleep = false;
};

/// Throws the particles of a part of the tube anew: places and velocities by chance alone.
void disorder(Gas& gas, const Box& box, std::size_t begin, std::size_t end, Random& random)
{
    for (std::size_t i = begin; i < end; ++i) {
        for (int a = 0; a < 3; ++a)
            gas.particles[i].position[a] = static_cast<float>(box.lower[a] + box.size()[a] * random.uniform_double());
        const auto other = begin + static_cast<std::size_t>(static_cast<double>(end - begin) * random.uniform_double());
        std::swap(gas.particles[i].velocity, gas.particles[other].velocity);
        gas.particles[i].velocity = static_cast<float>(random.uniform_double() < 0.5 ? -1 : 1) * gas.particles[i].velocity;
    }
}

Gas tube_of(const Wanted& wanted)
{
    const std::vector<std::size_t> counts = share_particles({explosive_density * layer, air_density * (wall - layer)}, wanted.count);
    const double spacing = layer / wanted.layers;
    const double section = static_cast<double>(counts[0]) * spacing * spacing * spacing / layer, width = std::sqrt(section);
    Gas gas;
    gas.settings = wanted.settings;
    gas.domain.box = {{0, 0, 0}, {wall, width, width}};
    const double volume = section * layer, rest = section * (wall - layer);
    gas.species.push_back({"products", products, explosive_density * volume / static_cast<double>(counts[0]), internal_freedoms(1.3)});
    gas.species.push_back({"air", IdealGas{1.4}, air_density * rest / static_cast<double>(counts[1]), internal_freedoms(1.4)});
    const Box hot{{0, 0, 0}, {layer, width, width}}, cold{{layer, 0, 0}, {wall, width, width}};
    fill(gas, {Shape::box(hot), {}, 0, explosive_density, explosive_energy, {}, -1}, counts[0]);
    fill(gas, {Shape::box(cold), {}, 1, air_density, air_energy, {}, -1}, counts[1]);
    gas.ambient = {1, air_density, 0.4 * air_density * air_energy, 0.4 * air_energy};
    if (wanted.sleep) gas.sleeping.disturbances.push_back({hot, 0});
    if (!wanted.quiet) {
        Random random(wanted.settings.seed, Purpose::fill, 1, 77);
        disorder(gas, hot, 0, counts[0], random);
        disorder(gas, cold, counts[0], gas.particles.size(), random);
    }
    return gas;
}

void particles(const Wanted& wanted)
{
    Gas gas = tube_of(wanted);
    const FacetTree nothing{Surface{}};
    lay_to_sleep(gas, nothing);
    sort(gas);
    survey(gas);
    const double started = cpu_seconds(), section = gas.domain.box.size().y * gas.domain.box.size().z;
    Clock clock;
    WallRecord record;
    while (clock.time() < end_time) {
        const double before = clock.time(), impulse = gas.passages.face[1].momentum.x;
        clock.begin_step(std::min(stable_step(gas, before), 0.5 * interval));
        wake(gas, clock);
        sort(gas);
        collide(gas, clock, nothing);
        fly(gas, clock, nothing);
        clock.end_step();
        record.add(before, clock.time(), (gas.passages.face[1].momentum.x - impulse) / section);
    }
    const GasSettings& s = wanted.settings;
    std::printf(
        "{\"kind\": \"particles\", \"particles\": %zu, \"layers\": %g, \"kappa\": %g, \"cell\": %u, \"cfl\": %g, \"partners\": %u, "
        "\"quiet\": %s, \"sleep\": %s, \"seed\": %d, ",
        wanted.count, wanted.layers, s.mean_free_path, s.cell_limit, s.cfl, s.partners, wanted.quiet ? "true" : "false",
        wanted.sleep ? "true" : "false", static_cast<int>(s.seed));
    record.print(cpu_seconds() - started, static_cast<double>(clock.step()));
}

}  // namespace

int main(int count, char** words)
{
    const auto number = [&](int i) { return i < count ? std::atof(words[i]) : 0.0; };
    const std::string what = count > 1 ? words[1] : "";
    if (what == "exact" && count == 3) {
        exact(static_cast<std::size_t>(number(2)));
    } else if (what == "particles" && count == 11) {
        const GasSettings settings{.seed = static_cast<std::uint64_t>(number(10)),
                                   .cell_limit = static_cast<std::uint32_t>(number(5)),
                                   .partners = static_cast<std::uint32_t>(number(7)),
                                   .mean_free_path = number(4),
                                   .cfl = number(6)};
        particles(
            {static_cast<std::size_t>(number(2)), number(3), settings, std::string(words[8]) == "quiet", std::string(words[9]) == "sleep"});
    } else {
        std::fprintf(stderr, "expected: exact CELLS, or particles N LAYERS KAPPA CELL CFL PARTNERS quiet|random sleep|awake SEED\n");
        return 2;
    }
    return 0;
}
