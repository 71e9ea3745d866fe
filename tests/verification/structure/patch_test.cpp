#include <gtest/gtest.h>

#include <random>

#include "../../unit/structure/plates.hpp"

namespace corpuscle {
namespace {

constexpr double thickness = 0.01, rate = 1e-8;  // so small that what is of second order in it does not show

/// A distorted mesh of 6 by 6 elements, moved by the same small step of `velocity` and `spin` at every node.
template <class Velocity, class Spin>
Structure deformed(const Velocity& velocity, const Spin& spin)
{
    Structure structure;
    add_part(structure, plate(square_mesh(6, 0.6, 0.25), elastic_steel(), thickness));
    Nodes& n = structure.nodes;
    Clock clock;
    clock.begin_step(1.0);
    for (std::size_t i = 0; i < n.size(); ++i) {
        n.velocity[i] = velocity(n.reference[i]);
        n.angular_velocity[i] = spin(n.reference[i]);
        n.position[i] += n.velocity[i];
    }
    resist(structure, clock);
    return structure;
}

/// Largest force and moment at inner nodes, which constant stress must leave in balance.
double unrest(const Structure& structure)
{
    double most = 0;
    const Nodes& n = structure.nodes;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const Vector3d& x = n.reference[i];
        const bool inside = x.x > 0.05 && x.x < 0.55 && x.y > 0.05 && x.y < 0.55;
        if (inside) most = std::max({most, norm(n.force[i]), norm(n.moment[i]) / thickness});
    }
    return most;
}

const QuadrilateralShells& shells(const Structure& structure)
{
    return std::get<QuadrilateralShells>(structure.parts[0].elements);
}

const double plane = 212e9 / (1.0 - 0.28 * 0.28), shear = 212e9 / 2.56;

TEST(Patch, MembraneStressIsConstantOnADistortedMesh)
{
    const Structure s = deformed([](const Vector3d& x) { return rate * Vector3d{x.x + 0.5 * x.y, 0.3 * x.y + 0.2 * x.x, 0.0}; },
                                 [](const Vector3d&) { return rate * Vector3d{0.0, 0.0, 0.5 * (0.2 - 0.5)}; });  // the plane's spin
    const double sum = plane * rate * 1.28 * 1.3, gap = plane * rate * 0.72 * 0.7, tangent = shear * rate * 0.7;
    for (std::size_t e = 0; e < s.element_count(); ++e) {
        for (int p = 0; p < 5; ++p) {
            const PlaneStress<double> stress =
                shells(s).point(e, p).stress;  // in axes of the element: compare what does not depend on them
            const double radius = std::hypot(0.5 * (stress.xx - stress.yy), stress.xy);
            EXPECT_NEAR(stress.xx + stress.yy, sum, 1e-5 * sum);
            EXPECT_NEAR(radius, std::hypot(0.5 * gap, tangent), 1e-5 * sum);
            EXPECT_NEAR(stress.zx, 0.0, 1e-9 * sum);
        }
    }
    EXPECT_LT(unrest(s), 1e-5 * sum * 0.1 * thickness);
    EXPECT_LT(std::abs(energy(s).hourglass), 1e-10 * energy(s).internal);
}

TEST(Patch, BendingMomentIsConstantOnADistortedMeshWithoutShear)
{
    const double a = 1.0, b = 0.4, c = 0.3;  // w = (a x^2 + b y^2) / 2 + c x y, turned by its own slope
    const Structure s =
        deformed([=](const Vector3d& x) { return rate * Vector3d{0.0, 0.0, 0.5 * a * x.x * x.x + 0.5 * b * x.y * x.y + c * x.x * x.y}; },
                 [=](const Vector3d& x) { return rate * Vector3d{b * x.y + c * x.x, -a * x.x - c * x.y, 0.0}; });
    const double height = 0.5 * thickness * 0.906179845938664;  // of the outermost of five Gauss points
    const double sum = plane * rate * height * 1.28 * (a + b),
                 radius = std::hypot(0.5 * plane * 0.72 * (a - b), shear * 2.0 * c) * rate * height;
    for (std::size_t e = 0; e < s.element_count(); ++e) {
        const PlaneStress<double> low = shells(s).point(e, 0).stress, middle = shells(s).point(e, 2).stress,
                                  up = shells(s).point(e, 4).stress;
        EXPECT_NEAR(up.xx + up.yy, -sum, 1e-5 * sum);
        EXPECT_NEAR(low.xx + low.yy, sum, 1e-5 * sum);
        EXPECT_NEAR(std::hypot(0.5 * (up.xx - up.yy), up.xy), radius, 1e-5 * sum);
        EXPECT_NEAR(middle.xx + middle.yy, 0.0, 1e-5 * sum);
        EXPECT_NEAR(std::hypot(up.zx, up.yz), 0.0, 1e-5 * sum);
    }
    EXPECT_LT(unrest(s), 1e-5 * sum * 0.1 * thickness);
    EXPECT_LT(std::abs(energy(s).hourglass), 1e-10 * energy(s).internal);
}

TEST(Patch, TransverseShearIsConstant)
{
    const Structure s = deformed([](const Vector3d& x) { return rate * Vector3d{0.0, 0.0, 0.5 * x.x - 0.2 * x.y}; },
                                 [](const Vector3d&) { return Vector3d{}; });
    for (std::size_t e = 0; e < s.element_count(); ++e) {
        const PlaneStress<double> stress = shells(s).point(e, 2).stress;
        EXPECT_NEAR(std::hypot(stress.zx, stress.yz), shear * rate * std::hypot(0.5, 0.2), 1e-5 * shear * rate);
    }
}

}  // namespace
}  // namespace corpuscle
