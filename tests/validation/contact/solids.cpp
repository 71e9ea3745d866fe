#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string>

#include "../../unit/structure/taylor_bar.hpp"
#include "contact/conwep_load.hpp"

// Figures of shells, bricks and tetrahedra against one another and against the literature (docs/validation.md).

namespace corpuscle {
namespace {

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

PartDescription in_tetrahedra(PartDescription d)
{
    d.mesh = cut_into_tetrahedra(std::move(d.mesh));
    return d;
}

PartDescription fully(PartDescription d)
{
    d.full_integration = true;
    return d;
}

void taylor()
{
    const TaylorBar bar;
    for (const int across : {4, 6}) {
        const double size = bar.radius / across;
        const std::pair<const char*, PartDescription> models[] = {
            {"one-point bricks", bar.part(size)}, {"full bricks", fully(bar.part(size))}, {"tetrahedra", in_tetrahedra(bar.part(size))}};
        for (const auto& [name, part] : models) {
            const double start = cpu_seconds();
            const TaylorResult r = run_taylor(bar, part);
            std::printf(
                "{\"test\": \"taylor\", \"element\": \"%s\", \"across\": %d, \"elements\": %zu, \"length_mm\": %.4f, \"foot_mm\": %.4f, "
                "\"plastic_strain\": %.4f, \"energy_error\": %.2e, \"hourglass\": %.4f, \"cpu_s\": %.2f}\n",
                name, across, part.mesh.elements.size(), 1e3 * r.length, 1e3 * r.foot, r.plastic_strain, r.energy_error, r.hourglass,
                cpu_seconds() - start);
            std::fflush(stdout);
        }
    }
}

/// Follows a structure until its probed node comes back; returns the largest way of that node along -z. [m]
struct Peak {
    double way = 0, time = 0;
};

template <class Load>
Peak first_peak(Structure& s, std::uint32_t node, double end, const Load& load)
{
    Peak peak;
    Clock clock;
    double duration = 0.95 * stable_step(s);
    while (clock.time() < end) {
        if (duration > stable_step(s) || duration < 0.8 * stable_step(s)) duration = 0.95 * stable_step(s);
        clock.begin_step(duration);
        accelerate(s, clock);
        load(clock);
        resist(s, clock);
        clock.end_step();
        const double way = s.nodes.reference[node].z - s.nodes.position[node].z;
        if (way > peak.way) peak = {way, clock.time()};
        if (peak.way > 0.001 && way < 0.9 * peak.way) break;
    }
    return peak;
}

/// The paper's plate in one quarter, radius 500 mm, 20 mm thick; its lower side's middle is the probed node.
PartDescription paper_plate(double size, int layers)
{
    const Mesh disk = disk_mesh(0.5, size, true);
    PartDescription d = layers > 0 ? block(extruded(disk, {0, 0, -0.02}, layers), armour_steel()) : plate(disk, armour_steel(), 0.02);
    d.holds = {clamp(select_nodes(d.mesh, "rim")), symmetry(select_nodes(d.mesh, "x=0"), 0), symmetry(select_nodes(d.mesh, "y=0"), 1)};
    return d;
}

void paper_plates()
{
    struct Model {
        const char* name;
        PartDescription part;
    };
    const Model models[] = {{"shells, 20 mm", paper_plate(0.02, 0)},
                            {"shells, 10 mm", paper_plate(0.01, 0)},
                            {"one-point bricks, 20 mm, 3 layers", paper_plate(0.02, 3)},
                            {"one-point bricks, 10 mm, 4 layers", paper_plate(0.01, 4)},
                            {"full bricks, 10 mm, 4 layers", fully(paper_plate(0.01, 4))}};
    for (const Model& model : models) {
        const double start = cpu_seconds();
        Structure s;
        add_part(s, model.part);
        ConwepLoad load(s, 0, {15.0, {0, 0, 0.7}, Burst::spherical, 0.0});
        const std::uint32_t middle = nearest_node(model.part.mesh, {0, 0, 0});
        const Peak peak = first_peak(s, middle, 2e-3, [&](const Clock& clock) { load.apply(clock); });
        std::printf(
            "{\"test\": \"plate\", \"model\": \"%s\", \"elements\": %zu, \"peak_mm\": %.3f, \"time_ms\": %.4f, \"plastic_strain\": %.4f, "
            "\"hourglass_share\": %.4f, \"cpu_s\": %.2f}\n",
            model.name, s.element_count(), 1e3 * peak.way, 1e3 * peak.time, max_plastic_strain(s.parts[0]),
            energy(s).hourglass / std::max(1e-30, energy(s).internal), cpu_seconds() - start);
        std::fflush(stdout);
    }
}

/// A clamped plate of mild steel under an impulse: radius `scale` * 50 mm, thickness `scale` * 1.6 mm.
double impulse_deflection(double speed, double scale, bool rate, int around)
{
    const double radius = 0.05 * scale, thickness = 0.0016 * scale;
    const Material steel{"mild", 7850, 207e9, 0.3, BilinearPlastic{282e6, 0.0, rate ? 40.4 : 0.0, 5.0, 0.0}};
    PartDescription d = plate(disk_mesh(radius, radius / around, true), steel, thickness);
    d.holds = {clamp(select_nodes(d.mesh, "rim")), symmetry(select_nodes(d.mesh, "x=0"), 0), symmetry(select_nodes(d.mesh, "y=0"), 1)};
    d.velocity = {0, 0, -speed};
    Structure s;
    add_part(s, d);
    const std::uint32_t middle = nearest_node(d.mesh, {0, 0, 0});
    return first_peak(s, middle, 1e-3 * scale, [](const Clock&) {}).way / thickness;
}

void impulses()
{
    const double density = 7850, yield = 282e6, ratio = 0.05 / 0.0016;
    for (const double speed : {40.0, 80.0, 120.0, 160.0}) {
        const double phi = density * speed * ratio / std::sqrt(density * yield);  // I / (pi R t^2 sqrt(rho sigma)) with I = rho t V pi R^2
        const double one = impulse_deflection(speed, 1, true, 16), without = impulse_deflection(speed, 1, false, 16),
                     two = impulse_deflection(speed, 2, false, 16), two_rate = impulse_deflection(speed, 2, true, 16);
        std::printf(
            "{\"test\": \"impulse\", \"speed\": %.0f, \"phi\": %.3f, \"with_rate\": %.4f, \"without_rate\": %.4f, \"twice_the_size\": "
            "%.4f, "
            "\"twice_the_size_with_rate\": %.4f, \"nurick_martin\": %.4f}\n",
            speed, phi, one, without, two, two_rate, 0.425 * phi + 0.277);
        std::fflush(stdout);
    }
}

/// Deflection of the panel's middle. [in]
struct Panel {
    double largest = 0, late = 0;
};

/// A quarter of the 120-degree cylindrical panel, clamped along its straight sides and hinged at its ends, thrown inward over the middle
/// 10.205 in by 3.08 in of arc at 5650 in/s.
Panel panel_deflection(int across, int along, bool triangles)
{
    constexpr double inch = 0.0254, radius = 2.9375 * inch, thickness = 0.125 * inch, half_length = 6.28 * inch;
    constexpr double angle = std::numbers::pi / 3, loaded_arc = 1.54 * inch, loaded_length = 5.1025 * inch;
    Mesh mesh;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i <= across; ++i) {
            const double a = angle * i / across;
            mesh.nodes.push_back({radius * std::sin(a), half_length * j / along, radius * std::cos(a)});
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (across + 1) + i); };
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < across; ++i)
            mesh.elements.push_back({ElementShape::quadrilateral, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    std::vector<std::uint32_t> crown, middle, side, end;
    for (int j = 0; j <= along; ++j) {
        crown.push_back(at(0, j));
        side.push_back(at(across, j));
    }
    for (int i = 0; i <= across; ++i) {
        middle.push_back(at(i, 0));
        end.push_back(at(i, along));
    }
    const Material aluminium{"6061", 2671.8, 72.39e9, 0.33, BilinearPlastic{303.4e6, 0.0, 0.0, 1.0, 0.0}};
    PartDescription d = plate(std::move(mesh), aluminium, thickness);
    if (triangles) {
        for (std::size_t e = 0, count = d.mesh.elements.size(); e < count; ++e) {
            const auto n = d.mesh.elements[e].node;
            d.mesh.elements[e] = {ElementShape::triangle, {n[0], n[1], n[2], 0, 0, 0, 0, 0}};
            d.mesh.elements.push_back({ElementShape::triangle, {n[0], n[2], n[3], 0, 0, 0, 0, 0}});
        }
    }
    d.holds = {symmetry(crown, 0), symmetry(middle, 1), clamp(side), pin(end)};
    Structure s;
    add_part(s, d);
    for (std::size_t i = 0; i < s.nodes.size(); ++i) {
        const Vector3d& x = s.nodes.reference[i];
        const double arc = radius * std::atan2(x.x, x.z);
        if (arc > loaded_arc * 1.001 || x.y > loaded_length * 1.001) continue;
        const Vector3d inward = -Vector3d{x.x, 0, x.z} / radius;
        s.nodes.velocity[i] = 5650 * inch * Vector3d{x.x < 1e-9 ? 0.0 : inward.x, 0, inward.z};
    }
    Clock clock;
    const double duration = 0.8 * stable_step(s);
    Panel result;
    int count = 0;
    while (clock.time() < 1e-3) {
        step(s, clock, std::min(duration, 0.95 * stable_step(s)));
        const double way = (s.nodes.reference[0].z - s.nodes.position[0].z) / inch;
        result.largest = std::max(result.largest, way);
        if (clock.time() < 0.6e-3) continue;
        result.late += way;  // the mean of the elastic ringing about the permanent set
        ++count;
    }
    result.late /= count;
    return result;
}

void panels()
{
    for (const auto& [across, along] : {std::pair{8, 16}, {16, 32}, {24, 48}}) {
        for (const bool triangles : {false, true}) {
            const Panel p = panel_deflection(across, along, triangles);
            std::printf(
                "{\"test\": \"panel\", \"mesh\": \"%d x %d a quarter\", \"shells\": \"%s\", \"largest_in\": %.4f, \"late_in\": %.4f}\n",
                across, along, triangles ? "three-node" : "four-node", p.largest, p.late);
            std::fflush(stdout);
        }
    }
}

}  // namespace
}  // namespace corpuscle

int main(int argc, char** argv)
{
    const std::string only = argc > 1 ? argv[1] : "";
    if (only.empty() || only == "taylor") corpuscle::taylor();
    if (only.empty() || only == "impulse") corpuscle::impulses();
    if (only.empty() || only == "panel") corpuscle::panels();
    if (only.empty() || only == "plate") corpuscle::paper_plates();
}
