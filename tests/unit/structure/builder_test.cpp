#include "structure/builder.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "plates.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

PartDescription good()
{
    return plate(square_mesh(2, 0.2), elastic_steel(), 0.01);
}

/// The message of the refusal, "" if there was none.
template <class Change>
std::string refusal(const Change& change, int parts_before = 0)
{
    Structure structure;
    for (int i = 0; i < parts_before; ++i) add_part(structure, good());
    PartDescription d = good();
    d.place = {"case.toml", 12, 3};
    change(d);
    try {
        add_part(structure, d);
    } catch (const InputError& e) {
        EXPECT_FALSE(e.remedy().empty()) << e.problem();
        EXPECT_EQ(e.place().line, 12) << e.problem();
        EXPECT_EQ(structure.parts.size(), parts_before);
        return e.problem();
    }
    return "";
}

std::vector<std::uint32_t> all_nodes(const Mesh& mesh)
{
    std::vector<std::uint32_t> nodes(mesh.nodes.size());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) nodes[i] = i;
    return nodes;
}

TEST(Builder, RefusesNonsenseByPartAndElement)
{
    using D = PartDescription;
    EXPECT_EQ(refusal([](D&) {}), "");
    EXPECT_THAT(refusal([](D& d) { d.mesh.elements.clear(); }), HasSubstr("part 'plate': its mesh has no elements"));
    EXPECT_THAT(refusal([](D& d) { d.mesh.elements[3].node[2] = 77; }), HasSubstr("element 4"));
    EXPECT_THAT(refusal([](D& d) { d.mesh.nodes[4] = {0.3, 0.1, 0.0}; }), HasSubstr("element 2"));
    EXPECT_THAT(refusal([](D& d) { std::swap(d.mesh.elements[1].node[1], d.mesh.elements[1].node[2]); }), HasSubstr("element 2"));
    EXPECT_THAT(refusal([](D& d) { d.element = ElementKind::solid; }), HasSubstr("is a surface element, and the part is solid"));
    EXPECT_THAT(refusal([](D& d) { d.material.strength = Fabric{}; }), HasSubstr("is a fabric, which does not bend"));
    EXPECT_THAT(refusal([](D& d) { d.thickness = 0; }), HasSubstr("element 1"));
    EXPECT_THAT(refusal([](D& d) { d.thickness = 0; }), HasSubstr("no mass"));
    EXPECT_THAT(refusal([](D& d) { d.thicknesses = {0.01, 0.01, std::numeric_limits<double>::quiet_NaN(), 0.01}; }),
                HasSubstr("element 3"));
    EXPECT_THAT(refusal([](D& d) { d.thicknesses = {0.01}; }), HasSubstr("1 thicknesses for 4 elements"));
    EXPECT_THAT(refusal([](D& d) { d.points = 1; }), HasSubstr("1 points"));
    EXPECT_THAT(refusal([](D& d) { d.points = 11; }), HasSubstr("11 points"));
    EXPECT_THAT(refusal([](D& d) { d.material.density = 0; }), HasSubstr("density"));
    EXPECT_THAT(refusal([](D& d) { d.holds = {clamp({9})}; }), HasSubstr("held node 9 does not exist"));
    EXPECT_THAT(refusal([](D&) {}, 1), HasSubstr("already a part of this name"));
    EXPECT_THAT(refusal([](D& d) {
                    d.element = ElementKind::rigid;
                    d.thickness = 0;
                }),
                HasSubstr("a rigid part that can move has no mass"));
    EXPECT_THAT(refusal([](D& d) { d.point_masses = {{{0, 1}, -1.0}}; }), HasSubstr("a point mass is -1 kg"));
    EXPECT_THAT(refusal([](D& d) {
                    d.element = ElementKind::rigid;
                    d.holds = {clamp({0, 1, 2, 3, 4, 5, 6, 7})};
                }),
                HasSubstr("has 8 of its 9 nodes held along x"));
}

TEST(Builder, MassesAddUpToThePart)
{
    Structure structure;
    add_part(structure, plate(square_mesh(5, 0.4, 0.2), elastic_steel(), 0.013));
    double mass = 0;
    for (const double m : structure.nodes.mass) mass += m;
    EXPECT_NEAR(mass, 7838.0 * 0.16 * 0.013, 1e-12);
    for (const double i : structure.nodes.inertia) EXPECT_GT(i, 0.0);
}

TEST(Builder, HoldsTakeTheRightDirections)
{
    PartDescription d = good();
    d.holds = {clamp({0}), pin({1}), symmetry({2, 3}, 0), symmetry({3}, 1)};
    d.velocity = {1.0, 2.0, 3.0};
    Structure structure;
    add_part(structure, d);
    const Nodes& n = structure.nodes;
    EXPECT_EQ(n.inverse_mass[0], Vector3d());
    EXPECT_EQ(n.inverse_inertia[0], Vector3d());
    EXPECT_EQ(n.inverse_mass[1], Vector3d());
    EXPECT_GT(n.inverse_inertia[1].z, 0);
    EXPECT_EQ(n.inverse_mass[2].x, 0);
    EXPECT_DOUBLE_EQ(n.inverse_mass[2].y, 1.0 / n.mass[2]);
    EXPECT_GT(n.inverse_inertia[2].x, 0);
    EXPECT_EQ(n.inverse_inertia[2].y, 0);
    EXPECT_EQ(n.inverse_inertia[2].z, 0);
    EXPECT_EQ(n.velocity[0], Vector3d());
    EXPECT_EQ(n.velocity[2], Vector3d(0.0, 2.0, 3.0));
    EXPECT_EQ(n.velocity[3], Vector3d(0.0, 0.0, 3.0));
    EXPECT_EQ(n.velocity[4], Vector3d(1.0, 2.0, 3.0));
}

TEST(Builder, SurfaceCoversEveryElementOnceWithItsNormal)
{
    PartDescription frame = good();
    frame.name = "frame";
    frame.element = ElementKind::rigid;
    frame.holds = {clamp(all_nodes(frame.mesh))};
    frame.mesh.elements[0].shape = ElementShape::triangle;
    Structure structure;
    add_part(structure, good());
    const Part& rigid = add_part(structure, frame);
    EXPECT_TRUE(rigid.rigid());
    EXPECT_EQ(rigid.first_node, 9);
    EXPECT_EQ(rigid.first_element, 4);
    ASSERT_EQ(structure.surface.facets.size(), 8 + 7);
    double area = 0;
    for (const Facet& f : structure.surface.facets) {
        const auto& x = structure.nodes.position;
        const Vector3d normal = cross(x[f.node[1]] - x[f.node[0]], x[f.node[2]] - x[f.node[0]]);
        EXPECT_GT(normal.z, 0);
        EXPECT_EQ(f.part, f.element / 4);
        area += 0.5 * normal.z;
    }
    EXPECT_NEAR(area, 0.04 + 0.035, 1e-15);
    EXPECT_EQ(structure.nodes.inverse_mass[9], Vector3d());
}

TEST(Builder, QuadrilateralsAreCutAlongTheShorterDiagonal)
{
    Mesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {0.5, 1, 0}};
    mesh.elements = {{ElementShape::quadrilateral, {0, 1, 2, 3}}};
    Structure structure;
    add_part(structure, plate(mesh, elastic_steel(), 0.1));
    EXPECT_EQ(structure.surface.facets[0].node, (std::array<std::uint32_t, 3>{0, 1, 3}));
    EXPECT_EQ(structure.surface.facets[1].node, (std::array<std::uint32_t, 3>{1, 2, 3}));
}

TEST(Builder, APartThatDeformsTurnsAboutItsCenterOfMassWhereItIsFree)
{
    PartDescription d = good();  // 0.2 m square
    const Vector3d spin{1, 2, 30}, velocity{4, 5, 6};
    d.spin = spin;
    d.velocity = velocity;
    d.holds = {pin({0})};
    Structure structure;
    add_part(structure, d);
    const Nodes& nodes = structure.nodes;
    Vector3d center;  // of equal squares: corners carry a quarter, edges a half of the middle's mass
    double mass = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        center += nodes.mass[n] * nodes.reference[n];
        mass += nodes.mass[n];
    }
    center = center / mass;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Vector3d expected = n == 0 ? Vector3d{} : velocity + cross(spin, nodes.reference[n] - center);
        EXPECT_NEAR(norm_squared(nodes.velocity[n] - expected), 0, 1e-24) << n;
        EXPECT_EQ(nodes.angular_velocity[n], spin) << n;
    }
}

}  // namespace
}  // namespace corpuscle
