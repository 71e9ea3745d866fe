#include "simulation/bench.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "contact/gas_structure.hpp"
#include "contact/grid_walls.hpp"
#include "euler/fill.hpp"
#include "euler/flow.hpp"
#include "gas/collide.hpp"
#include "gas/fill.hpp"
#include "gas/fly.hpp"
#include "gas/sort.hpp"
#include "math/random.hpp"
#include "mesh/extrude.hpp"
#include "mesh/generators.hpp"
#include "mesh/selection.hpp"
#include "parallel/loops.hpp"
#include "simulation/phases.hpp"
#include "structure/builder.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

namespace {

constexpr std::size_t records = 4'000'000;  ///< of the reference loops: 128 MB, beyond any cache
constexpr int repeats = 5;
const std::string reference_name = "reference: copy, nearly in order";

/// Median wall time of `work` over several repeats [s].
double median_seconds(const std::function<void()>& work)
{
    std::vector<double> seconds;
    for (int r = 0; r < repeats; ++r) {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + repeats / 2, seconds.end());
    return seconds[repeats / 2];
}

/// Collects lines of one number of threads.
class Bench {
public:
    Bench(const BenchSettings& settings, int threads) : settings_(settings), threads_(threads) { set_thread_count(threads); }

    void run()
    {
        measure_copies();
        if (wanted("reference")) measure_triad();
        if (wanted("gas")) measure_gas(settings_.particles, settings_.steps, true);
        if (settings_.name == "sizes") {
            for (const std::size_t particles : {100'000, 300'000, 1'000'000, 3'000'000, 10'000'000, 20'000'000}) {
                measure_gas(particles, std::max<int>(3, static_cast<int>(20'000'000 / particles)), false);
            }
        }
        if (wanted("shells")) measure_structure("shells: whole step", shell_plate());
        if (wanted("bricks")) {
            measure_structure("bricks, one point: whole step", brick_plate(false));
            measure_structure("bricks, eight points: whole step", brick_plate(true));
        }
        if (wanted("euler")) {
            measure_euler(false);
            measure_euler(true);
        }
        for (BenchLine& line : lines_) {
            line.ratio = line.nanoseconds / reference_;
            if (line.moved > 0) line.limit = line.nanoseconds / (line.moved * copy_per_byte_);
        }
    }
    [[nodiscard]] const std::vector<BenchLine>& lines() const { return lines_; }

private:
    [[nodiscard]] bool wanted(const std::string& name) const { return settings_.name.empty() || settings_.name == name; }
    void add(const std::string& name, double seconds, double things, double moved = 0, double resident = 0)
    {
        lines_.push_back({name, threads_, 1e9 * seconds / things, 0, moved, 0, resident});
    }

    /// Particles copied through an index: in order, displaced within a thousand (as a sort of a nearly sorted array does), at random.
    void measure_copies()
    {
        const std::vector<Particle> from(records);
        std::vector<Particle> to(records);
        std::vector<std::uint32_t> order(records);
        std::iota(order.begin(), order.end(), 0u);
        const auto copy = [&](const std::string& name) {
            add(name, median_seconds([&] { for_each(records, [&](std::size_t i) { to[i] = from[order[i]]; }); }), records,
                2 * sizeof(Particle));
        };
        copy("reference: copy, in order");
        copy_per_byte_ = lines_.back().nanoseconds / lines_.back().moved;
        Random random(1, Purpose::fill, 0, 0);
        constexpr std::uint32_t reach = 1024;
        for (std::size_t first = 0; first + reach <= records; first += reach) {
            for (std::uint32_t k = reach - 1; k > 0; --k) std::swap(order[first + k], order[first + random.below(k + 1)]);
        }
        copy(reference_name);
        reference_ = lines_.back().nanoseconds;
        if (!wanted("reference")) return;
        for (std::uint32_t k = records - 1; k > 0; --k) std::swap(order[k], order[random.below(k + 1)]);
        copy("reference: copy, at random");
    }

    void measure_triad()
    {
        std::vector<double> a(records), b(records, 1.0), c(records, 2.0);
        add("reference: triad", median_seconds([&] { for_each_simd(records, [&](std::size_t i) { a[i] = b[i] + 3.0 * c[i]; }); }), records,
            24);
    }

    /// Bytes of a particle that a phase must move at least: the sort reads all to see who leaves, then reads and writes all; the others
    /// read and write all.
    [[nodiscard]] static double moved_by(const std::string& phase)
    {
        return (phase == "sort" ? 3 : 2) * static_cast<double>(sizeof(Particle));
    }

    /// A closed box of gas, steps of the usual length, with a mean free path that gives a third of a collision a particle and step.
    void measure_gas(std::size_t particles, int steps, bool with_phases)
    {
        Gas gas;
        gas.domain.box = {{0, 0, 0}, {1, 1, 1}};
        gas.settings.mean_free_path = 0.21;
        gas.species.push_back({"air", IdealGas{1.4}, 1.2 / static_cast<double>(particles), internal_freedoms(1.4)});
        fill(gas, {Shape::box(gas.domain.box), {}, 0, 1.2, 0.253e6 / 1.2, {}, -1}, particles);
        sort(gas);
        survey(gas);
        const FacetTree nothing{Surface{}};
        Clock clock;
        Phases phases;
        const auto advance = [&](Phases& timed) {
            clock.begin_step(stable_step(gas, clock.time()));
            timed.time("sort", [&] { sort(gas); });
            timed.time("collide", [&] { collide(gas, clock, nothing); });
            timed.time("fly", [&] { fly(gas, clock, nothing); });
            clock.end_step();
        };
        Phases warm;
        for (int s = 0; s < 5; ++s) advance(warm);
        const std::uint64_t before = gas.collisions;
        for (int s = 0; s < steps; ++s) advance(phases);
        const double work = static_cast<double>(particles) * steps;
        double whole = 0, moved = 0;
        for (const auto& [name, seconds] : phases.seconds()) {
            if (with_phases) add("gas: " + name, seconds, work, moved_by(name));
            whole += seconds;
            moved += moved_by(name);
        }
        const double collisions = static_cast<double>(gas.collisions - before) / work;
        add(fmt::format("gas: whole step, {:.2g} particles, {:.2f} collisions", static_cast<double>(particles), collisions), whole, work,
            moved, static_cast<double>(resident_bytes(gas) + gas.cells.sort_bytes) / static_cast<double>(particles));
    }

    /// The quarter plate of the paper, hit by an initial velocity so that it yields.
    static PartDescription plate_of(Mesh mesh)
    {
        PartDescription plate;
        plate.name = "plate";
        plate.mesh = std::move(mesh);
        plate.material = {"rha", 7838, 212e9, 0.28, BilinearPlastic{1200e6, 6500e6, 300, 5, 0}};
        plate.thickness = 0.02;
        plate.holds.push_back(clamp(select_nodes(plate.mesh, "rim")));
        plate.velocity = {0, 0, -150};
        return plate;
    }
    static PartDescription shell_plate() { return plate_of(disk_mesh(0.5, 0.005, true)); }
    static PartDescription brick_plate(bool full)
    {
        PartDescription plate = plate_of(extruded(disk_mesh(0.5, 0.01, true), {0, 0, -0.02}, 4));
        plate.element = ElementKind::solid;
        plate.full_integration = full;
        return plate;
    }

    void measure_structure(const std::string& name, const PartDescription& part)
    {
        Structure structure;
        add_part(structure, part);
        Clock clock;
        const int steps = 100;
        const double seconds = median_seconds([&] {
            for (int s = 0; s < steps; ++s) {
                clock.begin_step(0.9 * stable_step(structure));
                accelerate(structure, clock);
                resist(structure, clock);
                clock.end_step();
            }
        });
        add(name, seconds, static_cast<double>(structure.element_count()) * steps);
    }

    /// Products and air in space: a ball of burnt TNT, in a corner of mirrors, that has grown to half of the box; every block is computed.
    /// A surface askew across the unit cube, of facets twice as wide as its cells, that moves slowly.
    static Structure sheet_in_grid()
    {
        constexpr std::uint32_t pieces = 32;
        Structure structure;
        std::vector<Vector3d> places;
        for (std::uint32_t j = 0; j <= pieces; ++j) {
            for (std::uint32_t i = 0; i <= pieces; ++i) {
                const double x = double(i) / pieces, y = double(j) / pieces;
                places.emplace_back(1.2 * x - 0.1, 1.2 * y - 0.1, 0.7 + 0.1 * x + 0.05 * y);
            }
        }
        for (std::uint32_t j = 0; j < pieces; ++j) {
            for (std::uint32_t i = 0; i < pieces; ++i) {
                const std::uint32_t q = i + (pieces + 1) * j;
                structure.surface.facets.push_back({{q, q + 1, q + pieces + 2}});
                structure.surface.facets.push_back({{q, q + pieces + 2, q + pieces + 1}});
            }
        }
        structure.nodes.add(places);
        for (Vector3d& velocity : structure.nodes.velocity) velocity = {0, 0, 5};
        structure.nodes.previous = structure.nodes.position;
        return structure;
    }
    static void move(Nodes& nodes, double duration)
    {
        nodes.previous = nodes.position;
        for (std::size_t n = 0; n < nodes.size(); ++n) nodes.position[n] += duration * nodes.velocity[n];
    }

    /// A charge that bursts in air, on 64^3 cells; with a surface in the flow or without.
    void measure_euler(bool walled)
    {
        EulerSettings all;
        all.skip_quiet = false;
        std::array<EulerEdge, euler_face_count> edges;
        edges.fill(EulerEdge::rigid);
        const std::vector<double> faces = even_faces(0, 1, 64);
        const Jwl products{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
        EulerGrid grid =
            make_grid(EulerSpace::planar, {faces, faces, faces}, edges, {{"products", products, {}}, {"air", IdealGas{1.4}, {}}}, all);
        fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}}, {Shape::sphere({0, 0, 0}, 0.5), {0, 1630, 0, {}, 7e9 / 1630}}});
        Structure structure = walled ? sheet_in_grid() : Structure{};
        GridWalls walls(grid, structure);
        walls.begin();
        Clock clock;
        const auto advance = [&](int steps) {
            for (int s = 0; s < steps; ++s) {
                clock.begin_step(std::min(stable_step(grid), walls.stable_step()));
                move(structure.nodes, clock.duration());
                walls.apply(clock);
                flow(grid, clock);
                clock.end_step();
            }
        };
        advance(5);
        const int steps = 4;
        const double cells = static_cast<double>(grid.cells());
        add(walled ? "euler: the same, with a surface in it" : "euler: whole step, products and air",
            median_seconds([&] { advance(steps); }), cells * steps, 2 * 7 * sizeof(double), 2 * 7 * sizeof(double));
    }

    const BenchSettings& settings_;
    int threads_;
    double reference_ = 1;      ///< [ns]
    double copy_per_byte_ = 1;  ///< of the copy in order [ns]
    std::vector<BenchLine> lines_;
};

}  // namespace

const std::vector<std::string>& bench_names()
{
    static const std::vector<std::string> names{"reference", "gas", "sizes", "shells", "bricks", "euler"};
    return names;
}

std::vector<BenchLine> run_bench(const BenchSettings& settings)
{
    const auto& names = bench_names();
    if (!settings.name.empty() && std::find(names.begin(), names.end(), settings.name) == names.end()) {
        throw InputError("there is no benchmark '" + settings.name + "'", "expected one of: reference, gas, sizes, shells, bricks, euler");
    }
    const int threads_before = thread_count();
    std::vector<BenchLine> lines;
    for (const int threads : settings.threads) {
        Bench bench(settings, threads);
        bench.run();
        lines.insert(lines.end(), bench.lines().begin(), bench.lines().end());
    }
    set_thread_count(threads_before);
    return lines;
}

std::string bench_json(const std::vector<BenchLine>& lines)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const BenchLine& line : lines) {
        list.push_back({{"name", line.name},
                        {"threads", line.threads},
                        {"ns_per_thing_and_step", line.nanoseconds},
                        {"over_reference_copy", line.ratio},
                        {"least_bytes_moved", line.moved},
                        {"over_memory_limit", line.limit},
                        {"resident_bytes", line.resident}});
    }
    return nlohmann::ordered_json{{"version", 1}, {"lines", list}}.dump(2);
}

}  // namespace corpuscle
