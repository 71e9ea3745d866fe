#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "gas/fill.hpp"
#include "mesh/generators.hpp"
#include "parallel/loops.hpp"
#include "simulation/simulation.hpp"
#include "structure/builder.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

constexpr double edge = 0.1;  ///< of the closed box of gas [m]

/// A square steel plate of 4 x 4 shells, free and at rest in the middle of a closed box of hot air that is denser below it.
std::unique_ptr<Model> plate_in_box(double element_size)
{
    const double side = 4 * element_size;
    PartDescription plate;
    plate.name = "plate";
    plate.mesh = rectangle_mesh({0.5 * (edge - side), 0.5 * (edge - side), 0.5 * edge}, {side, 0, 0}, {0, side, 0}, element_size);
    plate.material = {"steel", 7838, 212e9, 0.28, Elastic{}};
    plate.thickness = 0.25 * element_size;
    Structure structure;
    add_part(structure, plate);
    Gas gas;
    gas.domain.box = {{0, 0, 0}, {edge, edge, edge}};
    constexpr double density = 20, energy = 1e6;
    constexpr std::size_t particles = 6'000;
    gas.species.push_back({"air", IdealGas{1.4}, 0.75 * density * edge * edge * edge / particles, internal_freedoms(1.4)});
    fill(gas, {Shape::box({{0, 0, 0}, {edge, edge, 0.5 * edge}}), {}, 0, density, energy, {}, -1}, particles * 2 / 3);
    fill(gas, {Shape::box({{0, 0, 0.5 * edge}, {edge, edge, edge}}), {}, 0, 0.5 * density, energy, {}, -1}, particles / 3);
    auto model = std::make_unique<Model>(std::move(gas), std::move(structure));
    model->end_time = 3e-5;
    model->output.history_every = 1e-5;
    return model;
}

/// What is left of a run: its summary, structure steps, and the places of nodes and particles at its end.
struct Ran {
    RunSummary summary;
    std::uint64_t structure_steps = 0;
    std::vector<Vector3d> nodes;
    std::vector<Vector3f> particles;
};

Ran remains(const Simulation& simulation)
{
    Ran ran{simulation.summary(), 0, simulation.model().structure.nodes.position, {}};
    ran.structure_steps = ran.summary.element_steps / simulation.model().structure.element_count();
    for (const Particle& particle : simulation.model().gas.particles) ran.particles.push_back(particle.position);
    return ran;
}

Ran run(double element_size, int threads = 1)
{
    set_thread_count(threads);
    const ScratchFolder scratch;
    const RunFolder folder(scratch.path() / "run");
    folder.create(Existing::refuse);
    Simulation simulation(plate_in_box(element_size), folder);
    const std::atomic<bool> never = false;
    simulation.run(never, [](const Progress&) {});
    return remains(simulation);
}

/// The same, stopped after some steps and resumed.
Ran run_in_two(double element_size, std::uint64_t steps)
{
    set_thread_count(1);
    const ScratchFolder scratch;
    const RunFolder folder(scratch.path() / "run");
    folder.create(Existing::refuse);
    std::atomic<bool> stop = false;
    Simulation first(plate_in_box(element_size), folder);
    EXPECT_EQ(first.run(stop, [&](const Progress& progress) { stop = progress.step >= steps; }), Ending::interrupted);
    const auto second = Simulation::resume(plate_in_box(element_size), folder);
    const std::atomic<bool> never = false;
    second->run(never, [](const Progress&) {});
    return remains(*second);
}

void expect_same(const Ran& a, const Ran& b)
{
    EXPECT_TRUE(a.nodes == b.nodes);
    EXPECT_TRUE(a.particles == b.particles);
}

/// What single precision of velocities allows: in some 1e3 steps at most 1e5 energies, each 1/6000 of the whole, are rounded by 1e-7; and
/// the structure's changes of its step, which the books count as an error.
void expect_closed_books(const Ran& ran)
{
    EXPECT_LT(ran.summary.mass_error, 1e-12);
    EXPECT_LT(ran.summary.momentum_error, 1e-6);
    EXPECT_LT(ran.summary.energy_error, 1e-4);
}

/// Elements [m] whose steps are a tenth of the gas's, about as long, and at least twice as long.
constexpr double tiny = 0.0006, alike = 0.009, large = 0.024;

double per_step(const Ran& ran)
{
    return static_cast<double>(ran.structure_steps) / static_cast<double>(ran.summary.steps);
}

TEST(StructurePace, NeitherBodySetsTheOthersStep)
{
    const Ran with_tiny = run(tiny), with_alike = run(alike), with_large = run(large);
    EXPECT_GT(per_step(with_tiny), 8);
    EXPECT_NEAR(per_step(with_alike), 1, 0.05);
    EXPECT_LE(per_step(with_large), 0.5);
    // The gas's step follows the hottest cell, whose temperature differs by some per cent from run to run.
    EXPECT_NEAR(static_cast<double>(with_tiny.summary.steps) / static_cast<double>(with_large.summary.steps), 1, 0.1);
    EXPECT_GT(with_alike.nodes[0].z, 0.5 * edge);  // blown upward
    EXPECT_GT(with_large.nodes[0].z, 0.5 * edge);
    for (const Ran& ran : {with_tiny, with_alike, with_large}) {
        expect_closed_books(ran);
    }
}

TEST(StructurePace, BitsDependNeitherOnThreadsNorOnARestart)
{
    for (const double size : {tiny, alike, large}) {
        const Ran whole = run(size);
        expect_same(whole, run(size, 3));
        for (const std::uint64_t steps : {7, 8}) expect_same(whole, run_in_two(size, steps));
    }
}

}  // namespace
}  // namespace corpuscle
