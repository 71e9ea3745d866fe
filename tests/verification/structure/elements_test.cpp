#include <gtest/gtest.h>

#include <functional>

#include "../../unit/structure/blocks.hpp"
#include "../../unit/structure/symmetric_eigen.hpp"

// The harness over every element. To add an element: one line in `cases`.

namespace corpuscle {
namespace {

constexpr double side = 0.4, thickness = 0.01, tiny = 1e-9;

/// An element kind, as the harness needs it: a part of about n elements along each side, inner nodes shifted by `crook` of an element.
struct Case {
    const char* name;
    bool solid;
    int free_modes;  ///< of one element alone: rigid motion, and for shells turning of nodes about the normal, in four-node shells but for
                     ///< its mean
    double bending_order;     ///< of the energy's error in pure bending; 0: exact, -1: bends freely
    double least_step_share;  ///< stable step over that of the element's highest frequency, at least; never above 1
    std::function<PartDescription(int n, double crook)> part;
};

PartDescription full(PartDescription d)
{
    d.full_integration = true;
    return d;
}

PartDescription membrane(PartDescription d)
{
    d.element = ElementKind::membrane;
    return d;
}

PartDescription cube(int n, double crook)
{
    return block(brick_mesh({n, n, n}, {side, side, side}, crook), elastic_steel());
}

PartDescription tetrahedra(int n, double crook)
{
    return block(tetrahedron_mesh({n, n, n}, {side, side, side}, crook), elastic_steel());
}

const std::vector<Case> cases{
    {"FourNodeShell", false, 9, 0.0, 0.99,
     [](int n, double crook) { return plate(square_mesh(n, side, crook), elastic_steel(), thickness); }},
    {"ThreeNodeShell", false, 8, 0.0, 0.7,
     [](int n, double crook) { return plate(triangle_mesh(n, side, crook), elastic_steel(), thickness); }},
    {"Membrane", false, 15, -1.0, 0.99,
     [](int n, double crook) { return membrane(plate(triangle_mesh(n, side, crook), elastic_steel(), thickness)); }},
    {"OnePointBrick", true, 6, 2.0, 0.9, [](int n, double crook) { return cube(n, crook); }},
    {"FullBrick", true, 6, 2.0, 0.7, [](int n, double crook) { return full(cube(n, crook)); }},
    {"Tetrahedron", true, 6, 1.8, 0.5, [](int n, double crook) { return tetrahedra(n, crook); }},
};

class ElementHarness : public testing::TestWithParam<Case> {
protected:
    /// The part after one step in which each node went by move(place) and turned by turn(place).
    template <class Move, class Turn>
    static Structure moved(const PartDescription& d, const Move& move, const Turn& turn)
    {
        Structure structure;
        add_part(structure, d);
        Nodes& n = structure.nodes;
        Clock clock;
        clock.begin_step(1.0);
        for (std::size_t i = 0; i < n.size(); ++i) {
            n.velocity[i] = move(n.reference[i]);
            n.angular_velocity[i] = turn(n.reference[i]);
            n.position[i] += n.velocity[i];
        }
        resist(structure, clock);
        return structure;
    }

    static bool is_inner(const Vector3d& x, bool solid)
    {
        const auto within = [](double a) { return a > 1e-6 && a < side - 1e-6; };
        return within(x.x) && within(x.y) && (!solid || within(x.z));
    }
};

const auto no_turn = [](const Vector3d&) { return Vector3d{}; };

double mises_of(const Structure& s, std::size_t element)
{
    return std::visit([&](const auto& e) { return e.values(element).von_mises; }, s.parts[0].elements);
}

/// Constant strain on a distorted mesh: every element has the exact stress, inner nodes are in balance, the energy is exact.
/// Bounds: the imposed motion is 1e-9, what is of second order in it 1e-9 of the stress; differences of places cost 1e-16/1e-9.
TEST_P(ElementHarness, PatchOfConstantStrain)
{
    const Case& c = GetParam();
    const double xx = tiny, yy = 0.3 * tiny, zz = -0.5 * tiny, xy = 0.2 * tiny, yz = 0.4 * tiny;
    const auto move = [&](const Vector3d& x) {
        if (!c.solid) return Vector3d{xx * x.x + xy * x.y, xy * x.x + yy * x.y, 0.0};
        return Vector3d{xx * x.x + xy * x.y, xy * x.x + yy * x.y + yz * x.z, yz * x.y + zz * x.z};
    };
    const Structure s = moved(c.part(4, 0.2), move, no_turn);
    SolidStress<double> stress = SolidStiffness(212e9, 0.28).stretched<double>({}, {xx, yy, zz, 2 * xy, 2 * yz, 0.0});
    double energy_density = 0.5 * work(stress, SolidStrain<double>{xx, yy, zz, 2 * xy, 2 * yz, 0.0}), volume = side * side * side;
    if (!c.solid) {
        const PlaneStress<double> flat = PlaneStiffness(212e9, 0.28).stretched<double>({}, {xx, yy, 2 * xy, 0.0, 0.0});
        stress = {flat.xx, flat.yy, 0.0, flat.xy, 0.0, 0.0};
        energy_density = 0.5 * (flat.xx * xx + flat.yy * yy + flat.xy * 2 * xy);
        volume = side * side * thickness;
    }
    const double scale = von_mises(stress);
    for (std::size_t e = 0; e < s.element_count(); ++e) EXPECT_NEAR(mises_of(s, e), scale, 1e-6 * scale) << e;
    for (std::size_t i = 0; i < s.nodes.size(); ++i) {
        if (is_inner(s.nodes.reference[i], c.solid)) {
            EXPECT_LT(norm(s.nodes.force[i]), 1e-6 * scale * side * (c.solid ? side : thickness)) << i;
        }
    }
    EXPECT_NEAR(energy(s).internal, energy_density * volume, 1e-6 * energy_density * volume);
    EXPECT_LT(std::abs(energy(s).hourglass), 1e-9 * energy(s).internal);
}

/// A stretched body that turns by 270 degrees keeps its stress and energy and gets no momentum. Solids read their spin in the middle of the
/// step, which is exact: 30 steps, 1e-9. Nodes of shells turn by vectors of their own, against which the chords of a step make shear of
/// angle^2/12 a radian: in 2000 steps of `angle` 2e-6 in all, 0.2 % of the strain.
TEST_P(ElementHarness, LargeRotationKeepsStressAndEnergy)
{
    const Case& c = GetParam();
    const int steps = c.solid ? 30 : 2000;
    const double strain = 1e-3, angle = 1.5 * std::numbers::pi / steps, bound = c.solid ? 1e-9 : 0.002;
    Structure s = moved(c.part(2, 0.2), [&](const Vector3d& x) { return Vector3d{strain * x.x, 0.0, 0.0}; }, no_turn);
    const double before = energy(s).internal, stress = mises_of(s, 0);
    const Vector3d axis = normalized(Vector3d{0.3, -0.5, 0.8});
    Clock clock;
    Nodes& n = s.nodes;
    for (int step = 0; step < steps; ++step) {
        clock.begin_step(1.0);
        for (std::size_t i = 0; i < n.size(); ++i) {
            const Vector3d x = n.position[i], along = dot(axis, x) * axis, out = x - along;
            n.velocity[i] = along + std::cos(angle) * out + std::sin(angle) * cross(axis, out) - x;
            n.angular_velocity[i] = angle * axis;
            n.position[i] += n.velocity[i];
        }
        resist(s, clock);
        clock.end_step();
    }
    EXPECT_NEAR(energy(s).internal / before, 1.0, bound);
    EXPECT_NEAR(mises_of(s, 0) / stress, 1.0, bound);
    Vector3d total;
    for (const Vector3d& force : n.force) total += force;
    EXPECT_LT(norm(total), 1e-9 * stress * side * side);
}

/// Stiffness of one element, column by column from unit motions, over the square roots of the masses (1 where there is none).
SquareMatrix mass_scaled_stiffness(const Case& c, bool with_masses)
{
    Structure s;
    PartDescription d = c.part(1, 0.0);
    d.mesh.elements.resize(1);
    std::vector<bool> used(d.mesh.nodes.size());
    for (int i = 0; i < node_count(d.mesh.elements[0].shape); ++i) used[d.mesh.elements[0].node[i]] = true;
    add_part(s, d);
    const Structure fresh = s;
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 0; i < used.size(); ++i)
        if (used[i]) nodes.push_back(i);
    const std::size_t each = c.solid ? 3 : 6;
    SquareMatrix k(each * nodes.size());
    const auto weight = [&](std::size_t dof) {
        const std::uint32_t node = nodes[dof / each];
        return with_masses ? std::sqrt(dof % each < 3 ? s.nodes.mass[node] : s.nodes.inertia[node]) : dof % each < 3 ? 1.0 : side;
    };
    for (std::size_t column = 0; column < k.size; ++column) {
        s = fresh;
        Clock clock;
        clock.begin_step(1.0);
        const std::uint32_t node = nodes[column / each];
        const int axis = static_cast<int>(column % 3);
        (column % each < 3 ? s.nodes.velocity : s.nodes.angular_velocity)[node][axis] = tiny;
        s.nodes.position[node] += s.nodes.velocity[node];
        resist(s, clock);
        for (std::size_t row = 0; row < k.size; ++row) {
            const auto& load = row % each < 3 ? s.nodes.force : s.nodes.moment;
            k.at(row, column) = -load[nodes[row / each]][static_cast<int>(row % 3)] / tiny / (weight(row) * weight(column));
        }
    }
    return k;
}

/// An element resists every motion but rigid ones (shells: and the turning of nodes about the normal), and symmetrically.
TEST_P(ElementHarness, OnlyRigidMotionIsFree)
{
    const Case& c = GetParam();
    const SquareMatrix k = mass_scaled_stiffness(c, false);
    const std::vector<double> values = eigenvalues(k);
    const double most = values.back();
    for (std::size_t i = 0; i < k.size; ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(k.at(i, j), k.at(j, i), 1e-6 * most);
    const auto is_free = [most](double value) { return std::abs(value) < 1e-6 * most; };
    EXPECT_EQ(std::count_if(values.begin(), values.end(), is_free), c.free_modes);
    EXPECT_GT(values.front(), -1e-6 * most);
}

/// The step an element allows is that of its highest frequency or a little less, never more (1e-5: round-off in the stiffness, 1e-16/1e-9,
/// grows in the eigenvalues).
TEST_P(ElementHarness, StepIsThatOfTheHighestFrequency)
{
    const Case& c = GetParam();
    Structure s;
    PartDescription d = c.part(1, 0.0);
    d.mesh.elements.resize(1);
    add_part(s, d);
    const double exact = 2.0 / std::sqrt(eigenvalues(mass_scaled_stiffness(c, true)).back()), allowed = stable_step(s) / 0.9;
    EXPECT_LT(allowed, 1.00001 * exact);
    EXPECT_GT(allowed, c.least_step_share * exact);
}

/// Energy of imposed pure bending about y, with the lateral bending that goes with it, against the exact one; its error falls as h^2.
TEST_P(ElementHarness, PureBendingConverges)
{
    const Case& c = GetParam();
    const double nu = 0.28, e = 212e9, z0 = c.solid ? 0.5 * side : 0.0;
    const auto move = [&](const Vector3d& p) {
        const double x = p.x, y = p.y, z = p.z - z0;
        return tiny * Vector3d{x * z, -nu * y * z, -0.5 * x * x + 0.5 * nu * (y * y - z * z)};
    };
    const auto turn = [&](const Vector3d& p) { return tiny * Vector3d{nu * p.y, p.x, 0.0}; };
    const double height = c.solid ? side : thickness;
    const double exact = 0.5 * e * tiny * tiny * side * (side * height * height * height / 12.0);
    std::vector<double> errors;
    for (const int n : {2, 4, 8}) {
        const Structure s = moved(c.part(n, 0.0), move, turn);
        errors.push_back(std::abs((energy(s).internal + energy(s).hourglass) / exact - 1.0));
    }
    if (c.bending_order < 0) {
        for (const double error : errors) EXPECT_NEAR(error, 1.0, 1e-9);
        return;
    }
    if (c.bending_order == 0) {
        for (const double error : errors) EXPECT_LT(error, 1e-5);
        return;
    }
    EXPECT_GT(std::log2(errors[1] / errors[2]), c.bending_order - 0.1);
    EXPECT_LT(errors[2], 0.1);
}

INSTANTIATE_TEST_SUITE_P(Elements, ElementHarness, testing::ValuesIn(cases), [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace corpuscle
