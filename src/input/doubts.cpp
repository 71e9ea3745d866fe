#include "input/doubts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "math/box.hpp"

namespace corpuscle {

namespace {

/// What is wrong with a part, one after the other.
class Doubts {
public:
    Doubts(const std::string& part, std::vector<std::string>& warnings) : part_(part), warnings_(warnings) {}
    void add(const std::string& doubt) { warnings_.push_back(fmt::format("part '{}': {}", part_, doubt)); }

private:
    const std::string& part_;
    std::vector<std::string>& warnings_;
};

/// The box around nodes as they were meshed. [m]
Box box_around(const Structure& structure, const Part& part)
{
    Box box;
    for (std::uint32_t n = part.first_node; n < part.first_node + part.node_count; ++n) box.include(structure.nodes.reference[n]);
    return box;
}

/// Rigid parts do not erode, and walls, which are held wholly, neither move nor weigh anything.
void doubt_rigid(const PartInput& input, bool wall, Doubts& doubts)
{
    if (input.erosion) doubts.add("it is rigid: its erosion has no effect");
    if (!wall) return;
    if (norm_squared(input.velocity) + norm_squared(input.spin) > 0 || !input.start.empty())
        doubts.add("it is rigid and held wholly: its velocity at the start has no effect");
    if (!input.point_masses.empty()) doubts.add("it is rigid and held wholly: its point masses have no effect");
}

/// The lowest yield stress a law begins with; nothing of laws without one. [Pa]
std::optional<double> first_yield(const Strength& strength)
{
    if (const auto* law = std::get_if<BilinearPlastic>(&strength)) return law->yield_stress;
    if (const auto* law = std::get_if<JohnsonCook>(&strength)) return law->a;
    if (const auto* law = std::get_if<CurvePlastic>(&strength)) return law->curves.front().points.front().stress;
    return std::nullopt;
}

/// A unit forgotten (MPa, GPa, g/cm3, t/mm3) shows in the speed of waves and in the strain at yield, which differ little among materials.
void doubt_material(const Material& material, Doubts& doubts)
{
    constexpr double slowest = 10, fastest = 30e3;             // rubber 30, diamond 18 000 [m/s]
    constexpr double least_strain = 1e-6, most_strain = 0.05;  // lead 3e-4, the strongest steels 0.015 [1]
    const double speed = std::sqrt(material.young_modulus / material.density);
    if (!(speed >= slowest && speed <= fastest))
        doubts.add(
            fmt::format("its Young's modulus of {:.4g} Pa and density of {:.4g} kg/m3 let sound run at {:.3g} m/s: are their units right?",
                        material.young_modulus, material.density, speed));
    const std::optional<double> yield = first_yield(material.strength);
    if (yield && !(*yield >= least_strain * material.young_modulus && *yield <= most_strain * material.young_modulus))
        doubts.add(fmt::format("it yields at {:.4g} Pa, a strain of {:.2g} by its Young's modulus of {:.4g} Pa: are their units right?",
                               *yield, *yield / material.young_modulus, material.young_modulus));
}

/// An exponent of the rate without its constant does nothing.
void doubt_rate(const MaterialValues& values, Doubts& doubts)
{
    const StrengthValues& s = values.strength;
    if ((s.bilinear && s.bilinear->rate_p > 0 && s.bilinear->rate_c == 0) || (s.curve && s.curve->rate_p > 0 && s.curve->rate_c == 0))
        doubts.add("its material has rate_p but no rate_c: the strain rate has no effect");
}

/// A shell thicker than half its part is wide is no shell: the thickness has lost its unit, or the mesh is in another.
void doubt_thickness(const PartDescription& built, const Box& box, Doubts& doubts)
{
    if (built.element != ElementKind::shell && built.element != ElementKind::membrane) return;
    const Vector3d size = box.size();
    const double width = std::max({size.x, size.y, size.z});
    if (built.thickness > 0.5 * width)
        doubts.add(
            fmt::format("its shells are {:.4g} m thick, and it is only {:.4g} m wide: are the units right?", built.thickness, width));
}

/// Elements below the limit of step at the start are taken out before anything happens; what does not yield has no plastic strain.
void doubt_erosion(const PartInput& input, const PartDescription& built, const Part& part, Doubts& doubts)
{
    if (!input.erosion) return;
    if (input.erosion->plastic_strain && std::visit([]<class Law>(const Law&) { return !Law::yields(); }, built.material.strength))
        doubts.add("its material does not yield: the erosion by plastic strain has no effect");
    if (!input.erosion->step) return;
    const std::size_t gone = std::visit(
        [&](const auto& elements) {
            std::size_t count = 0;
            for (std::size_t e = 0; e < elements.size(); ++e) count += 0.9 * elements.transit(e) < *input.erosion->step ? 1 : 0;
            return count;
        },
        part.elements);
    if (gone > 0)
        doubts.add(fmt::format(
            "{} of its {} elements have a stable step below that of its erosion ({:.4g} s) as meshed: they are taken out at once", gone,
            part.element_count(), *input.erosion->step));
}

/// The edges of a quarter are planes of symmetry: nodes there that are free to leave them make another structure.
void doubt_quarter(const PartInput& input, const Structure& structure, const Part& part, const Box& box, Doubts& doubts)
{
    const bool quarter = (input.mesh.disk && input.mesh.disk->quarter) || (input.mesh.ring && input.mesh.ring->quarter);
    if (!quarter) return;
    const Nodes& nodes = structure.nodes;
    for (int axis = 0; axis < 2; ++axis) {
        const double place = box.lower[axis];
        for (std::uint32_t n = part.first_node; n < part.first_node + part.node_count; ++n) {
            if (std::abs(nodes.reference[n][axis] - place) > 1e-6 * box.size()[axis] || nodes.inverse_mass[n][axis] == 0) continue;
            doubts.add(
                fmt::format("it is a quarter, but its edge {}={:.4g} is not held: fix = [{{ where = \"{}={:.9g}\", dof = \"symmetry\" "
                            "}}] makes it one",
                            "xy"[axis], place, "xy"[axis], place));
            break;
        }
    }
}

}  // namespace

void warn_of_doubts(const PartInput& input, const PartDescription& built, const Structure& structure, std::vector<std::string>& warnings)
{
    const Part& part = structure.parts.back();
    const Box box = box_around(structure, part);
    Doubts doubts(input.name, warnings);
    if (input.element.is_rigid()) {
        doubt_rigid(input, structure.nodes.body_of(part.first_node) == nullptr, doubts);
        return;
    }
    doubt_material(built.material, doubts);
    doubt_rate(*input.material->values, doubts);
    doubt_thickness(built, box, doubts);
    doubt_erosion(input, built, part, doubts);
    doubt_quarter(input, structure, part, box, doubts);
}

void warn_of_parts_outside(const CaseDescription& description, const Structure& structure, std::vector<std::string>& warnings)
{
    const bool grid = description.euler && description.euler->box.size() == 3;
    if (!description.gas && !grid) return;
    Box gas;
    for (int axis = 0; axis < 3; ++axis) {
        gas.lower[axis] = grid ? description.euler->box[axis][0] : description.gas->box[axis][0];
        gas.upper[axis] = grid ? description.euler->box[axis][1] : description.gas->box[axis][1];
    }
    for (const Part& part : structure.parts)
        if (!box_around(structure, part).overlaps(gas))
            Doubts(part.name, warnings).add("it lies outside the box of the gas, which will not meet it: are position and units right?");
}

}  // namespace corpuscle
