// Loads and prescribed motions against what mechanics says, and closed books in each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/curve_loads.hpp"
#include "mesh/extrude.hpp"
#include "mesh/generators.hpp"
#include "mesh/selection.hpp"
#include "model/model.hpp"
#include "structure/builder.hpp"
#include "structure/energy.hpp"

namespace corpuscle {
namespace {

Material steel(double poisson = 0.3)
{
    Material material;
    material.name = "steel";
    material.density = 7800;
    material.young_modulus = 2.1e11;
    material.poisson_ratio = poisson;
    material.strength = Elastic{};
    return material;
}

/// A square plate of shells, 0.2 m wide and 5 mm thick.
PartDescription plate(double element_size = 0.05)
{
    PartDescription part;
    part.name = "plate";
    part.mesh = rectangle_mesh({0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}, element_size);
    part.material = steel();
    part.thickness = 0.005;
    return part;
}

/// A rigid block of 3 kg.
PartDescription block()
{
    PartDescription part;
    part.name = "block";
    part.mesh = box_mesh({{0, 0, 0}, {0.1, 0.2, 0.3}}, 0.1);
    part.element = ElementKind::rigid;
    part.rigid.mass = 3;
    return part;
}

/// A model with its clock.
struct Bench {
    std::unique_ptr<Model> model;
    Clock clock;

    explicit Bench(std::initializer_list<PartDescription> parts)
    {
        Structure structure;
        for (const PartDescription& part : parts) add_part(structure, part);
        model = std::make_unique<Model>(Gas{}, std::move(structure));
    }

    /// Steps of the same length to the end, as the simulation makes them.
    void run(double end, int steps)
    {
        if (clock.step() == 0) model->ledger.open(model->held(0));
        const double duration = (end - clock.time()) / steps;
        double worst_energy = 0, worst_momentum = 0;
        for (int i = 0; i < steps; ++i) {
            clock.begin_step(duration);
            model->ledger.add(accelerate(model->structure, clock));
            model->ledger.add(resist(model->structure, clock));
            for (const auto& load : model->loads) model->ledger.add(load->apply(clock));
            model->ledger.close_step(model->held(duration));
            clock.end_step();
            worst_energy = std::max(worst_energy, model->ledger.error().energy);
            worst_momentum = std::max(worst_momentum, model->ledger.error().momentum);
        }
        EXPECT_LT(worst_energy, 1e-12);  // round-off: the step does not change
        EXPECT_LT(worst_momentum, 1e-12);
    }

    [[nodiscard]] Transfer given_by(const std::string& from) const
    {
        for (const Transfer& transfer : model->ledger.totals())
            if (transfer.from == from) return transfer;
        return {};
    }
};

TEST(Loads, WhatFallsFallsFreely)
{
    Bench bench({plate(), block()});
    const Vector3d g{0, 1, -9.81};
    bench.model->loads.push_back(std::make_unique<GravityLoad>(bench.model->structure, g));
    constexpr int steps = 500;
    constexpr double end = 1e-3, step = end / steps;
    bench.run(end, steps);
    const Nodes& nodes = bench.model->structure.nodes;
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        EXPECT_LT(norm(nodes.contact_velocity(n) - end * g), 1e-12 * norm(g));
        // A step's impulse acts at its end: g dt (1 + ... + (N - 1)) dt = g t (t - dt)/2.
        EXPECT_LT(norm(nodes.position[n] - nodes.reference[n] - 0.5 * end * (end - step) * g), 1e-15);
    }
    const double mass = 7800 * 0.2 * 0.2 * 0.005 + 3;
    EXPECT_NEAR(bench.given_by("gravity").momentum.z / (-9.81 * mass * end), 1, 1e-12);
}

TEST(Loads, PulseOfPressureGivesAFreePlateItsImpulse)
{
    Bench bench({plate()});
    const TimeCurve pulse({{0, 0}, {20e-6, 5e6}, {70e-6, 0}});  // 175 Pa s
    std::vector<std::uint32_t> all(bench.model->structure.nodes.size());
    for (std::uint32_t n = 0; n < all.size(); ++n) all[n] = n;
    bench.model->loads.push_back(std::make_unique<PressureLoad>(bench.model->structure, LoadedNodes{0, all, "pulse"}, pulse));
    bench.run(200e-6, 133);
    const Transfer given = bench.given_by("pressure");
    // Pressure follows the area: the plate shakes by less than its own way, 0.9 mm, over an element of 50 mm; areas change by half the
    // slope squared.
    EXPECT_NEAR(given.momentum.z / (-175 * 0.04), 1, 0.5 * 0.018 * 0.018);
    EXPECT_NEAR(momentum(bench.model->structure).z / given.momentum.z, 1, 1e-12);
    // A quadrilateral's triangles share their load by thirds, its mass is shared by quarters: so the plate also shakes, which takes more
    // work.
    const double rigid = 0.5 * 175 * 0.04 * 175 / (7800 * 0.005);
    EXPECT_GT(given.energy, rigid);
    const Vector3d mean = momentum(bench.model->structure) / (7800 * 0.04 * 0.005);
    EXPECT_NEAR(mean.z / -(175 / (7800 * 0.005)), 1, 0.5 * 0.018 * 0.018);
}

TEST(Loads, PressureMeetsOnlyTheFacetsAllOfWhoseNodesAreNamed)
{
    Bench bench({plate()});
    const std::vector<std::uint32_t> edge = select_nodes(plate().mesh, "x=0");
    EXPECT_THROW(PressureLoad(bench.model->structure, {0, edge, "edge"}, TimeCurve(1.0)), InputError);
    std::vector<std::uint32_t> strip = edge;
    for (const std::uint32_t node : select_nodes(plate().mesh, "x=0.05")) strip.push_back(node);
    std::sort(strip.begin(), strip.end());
    EXPECT_EQ(PressureLoad(bench.model->structure, {0, strip, "strip"}, TimeCurve(1.0)).facets().size(), 8u);
}

/// A bar along x whose end at x = 0 is driven; nothing moves across it.
double driven_bar(int cells, double speed, double time, Bench*& kept)
{
    PartDescription bar;
    bar.name = "bar";
    bar.element = ElementKind::solid;
    bar.material = steel(0.0);
    const double length = 1.0, h = length / cells;
    bar.mesh = extruded(rectangle_mesh({0, 0, 0}, {length, 0, 0}, {0, h, 0}, h), {0, 0, h}, 1);
    std::vector<std::uint32_t> all(bar.mesh.nodes.size());
    for (std::uint32_t n = 0; n < all.size(); ++n) all[n] = n;
    bar.holds = {{all, {false, true, true}, {}}};
    Drive drive;
    drive.nodes = select_nodes(bar.mesh, "x=0");
    drive.axis = 0;
    drive.curve = TimeCurve(speed);
    bar.drives = {drive};
    kept = new Bench({bar});
    kept->run(time, static_cast<int>(std::ceil(time / (0.6 * h / std::sqrt(2.1e11 / 7800)))));
    return h;
}

TEST(PrescribedMotion, OfABarsEndSendsTheWaveOfItsImpedance)
{
    // Behind the front all moves with the end's speed: momentum rho A c t v, half the work kinetic. The grid knows the front to about one
    // element, so momentum and work to that of one element.
    const double speed = 1, c = std::sqrt(2.1e11 / 7800), time = 0.7 / c;
    for (const int cells : {20, 80}) {
        Bench* kept = nullptr;
        const double h = driven_bar(cells, speed, time, kept);
        const std::unique_ptr<Bench> bench(kept);
        const Transfer given = bench->given_by("prescribed motion");
        const double expected = 7800 * h * h * 0.7 * speed, one = 7800 * h * h * h * speed;
        // The end's layer of nodes, half an element's mass, moved before the books were opened.
        EXPECT_NEAR(given.momentum.x + 0.5 * one, expected, one) << cells;
        EXPECT_NEAR(given.energy + 0.25 * one * speed, expected * speed, one * speed) << cells;
        EXPECT_NEAR(bench->model->structure.nodes.position[0].x, speed * time, 1e-14);
    }
}

TEST(PrescribedMotion, OfARigidBodyFollowsEachKindOfCurve)
{
    const double end = 1e-3;
    for (const DriveKind kind : {DriveKind::displacement, DriveKind::velocity, DriveKind::acceleration}) {
        PartDescription part = block();
        part.velocity = {0, 2, 5};
        Drive drive;
        drive.axis = 2;
        drive.kind = kind;
        for (std::uint32_t n = 0; n < part.mesh.nodes.size(); ++n) drive.nodes.push_back(n);
        drive.start_velocity = 5;
        drive.curve = kind == DriveKind::displacement ? TimeCurve({{0, 0}, {end, 0.02}}) : TimeCurve({{0, 5}, {end, 15}});
        part.drives = {drive};
        Bench bench({part});
        constexpr int steps = 100;
        bench.run(end, steps);
        const RigidBody& body = bench.model->structure.nodes.bodies[0];
        const double middle = end * (1 - 0.5 / steps);  // of the last step, where its velocity is known
        const double way = kind == DriveKind::displacement ? 0.02
                           : kind == DriveKind::velocity   ? 0.01
                                                           : 5 * end + 2.5 * end * end + 1e4 * end * end * end / 6;
        if (kind == DriveKind::displacement) {
            EXPECT_NEAR(body.velocity.z, 20, 1e-9);
        } else if (kind == DriveKind::velocity) {
            EXPECT_NEAR(body.velocity.z, 5 + 1e4 * middle, 1e-9);
        }
        EXPECT_NEAR(body.center.z - 0.15, way, 1e-14);
        EXPECT_NEAR(body.center.y - 0.1, 2 * end, 1e-14);
        const double start = kind == DriveKind::displacement ? 0 : 5;
        EXPECT_NEAR(bench.given_by("prescribed motion").momentum.z, 3 * (body.velocity.z - start), 1e-9);
        EXPECT_NEAR(bench.given_by("prescribed motion").energy, 1.5 * (body.velocity.z * body.velocity.z - start * start), 1e-7);
    }
}

TEST(PrescribedMotion, CarriesOtherLoadsWithoutLosingTheirWork)
{
    PartDescription part = block();
    Drive drive;
    drive.axis = 2;
    for (std::uint32_t n = 0; n < part.mesh.nodes.size(); ++n) drive.nodes.push_back(n);
    drive.curve = TimeCurve(4.0);
    part.drives = {drive};
    Bench bench({part});
    bench.model->loads.push_back(std::make_unique<GravityLoad>(bench.model->structure, Vector3d{0, 0, -9.81}));
    bench.run(1e-3, 100);
    // An even motion: what gravity gave, the drive took back, but for the last step's, which waits.
    EXPECT_NEAR(bench.given_by("prescribed motion").momentum.z, 3 * 9.81 * 0.99e-3, 1e-12);
    EXPECT_NEAR(bench.given_by("prescribed motion").energy, 3 * 9.81 * 0.99e-3 * 4, 1e-12);
    EXPECT_NEAR(bench.given_by("gravity").energy, -3 * 9.81 * 1e-3 * 4, 1e-12);
}

TEST(PrescribedMotion, IsRefusedWhereNodesAreHeldOrARigidBodyIsDrivenInPart)
{
    PartDescription held = plate();
    held.holds = {clamp({0})};
    held.drives = {{{0, 1}, -1, 2, DriveKind::velocity, TimeCurve(1.0), 0}};
    EXPECT_THROW(Bench({held}), InputError);
    PartDescription twice = plate();
    twice.drives = {{{0}, -1, 2, DriveKind::velocity, TimeCurve(1.0), 0}, {{0}, -1, 2, DriveKind::velocity, TimeCurve(1.0), 0}};
    EXPECT_THROW(Bench({twice}), InputError);
    PartDescription half = block();
    half.drives = {{{0, 1}, -1, 2, DriveKind::velocity, TimeCurve(1.0), 0}};
    EXPECT_THROW(Bench({half}), InputError);
}

/// What a rigid bar of the same nodes would start with, turned by weight about x = 0: g sum(m x)/sum(m x^2 + inertia). [1/s2]
double turning_rate(const Nodes& nodes, double g)
{
    double moment = 0, inertia = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const double x = nodes.reference[n].x;
        moment += nodes.mass[n] * x;
        inertia += nodes.mass[n] * x * x + nodes.inertia[n];
    }
    return g * moment / inertia;
}

/// Angle of a bar hinged at one end that falls from the horizontal, theta'' = rate cos(theta), by fine steps of Runge and Kutta.
double pendulum_angle(double rate, double time)
{
    constexpr int steps = 20'000;
    const double h = time / steps;
    double angle = 0, speed = 0;
    for (int i = 0; i < steps; ++i) {
        const double k1 = rate * std::cos(angle), s1 = speed;
        const double k2 = rate * std::cos(angle + 0.5 * h * s1), s2 = speed + 0.5 * h * k1;
        const double k3 = rate * std::cos(angle + 0.5 * h * s2), s3 = speed + 0.5 * h * k2;
        const double k4 = rate * std::cos(angle + h * s3), s4 = speed + h * k3;
        angle += h * (s1 + 2 * s2 + 2 * s3 + s4) / 6;
        speed += h * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    }
    return angle;
}

TEST(Loads, HingedBarSwingsAsAPendulum)
{
    const double length = 0.1, thickness = 0.01, g = 981;
    PartDescription bar;
    bar.name = "bar";
    bar.mesh = rectangle_mesh({0, 0, 0}, {length, 0, 0}, {0, 0.02, 0}, 0.01);
    bar.material = steel();
    bar.thickness = thickness;
    bar.holds = {pin(select_nodes(bar.mesh, "x=0"))};
    Bench bench({bar});
    bench.model->loads.push_back(std::make_unique<GravityLoad>(bench.model->structure, Vector3d{0, 0, -g}));
    const double time = 1.6 * std::sqrt(2 * length / (3 * g));
    bench.run(time, 10'000);
    const auto tip = nearest_node(bar.mesh, {length, 0.01, 0});
    const Vector3d at = bench.model->structure.nodes.position[tip];
    const double rate = turning_rate(bench.model->structure.nodes, g);
    EXPECT_NEAR(rate / (1.5 * g / length), 1, 0.03);  // lumped masses and rotary inertia against a thin bar: of second order in h/L and t/L
    const double angle = std::atan2(-at.z, at.x), expected = pendulum_angle(rate, time);
    EXPECT_GT(expected, 1.0);
    // It is not rigid: under its weight, put on at once, the tip of a clamped bar would swing by 2 x 1.5 rho g L^4/(E t^2); a hinged one
    // bends less.
    const double bend = 3 * 7800 * g * std::pow(length, 4) / (2.1e11 * thickness * thickness);
    EXPECT_NEAR(angle, expected, bend / length);
}

}  // namespace
}  // namespace corpuscle
