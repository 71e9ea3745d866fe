#include "laws/strength/material.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// Throws unless the condition holds; NaN never does.
void require(bool holds, const Material& material, const char* quantity, double value, const char* range)
{
    if (holds && std::isfinite(value)) return;
    throw InputError(fmt::format("material '{}': {} is {}", material.name, quantity, value), fmt::format("give a value {}", range));
}

void check_law(const Material&, const Elastic&) {}

void check_law(const Material& m, const BilinearPlastic& law)
{
    require(law.yield_stress > 0, m, "the yield stress", law.yield_stress, "above 0 Pa");
    require(law.hardening_modulus >= 0, m, "the hardening modulus", law.hardening_modulus, "of 0 Pa or more");
    require(law.rate_constant >= 0, m, "the rate constant C", law.rate_constant, "of 0 1/s (no rate effect) or more");
    require(law.rate_exponent >= 1, m, "the rate exponent p", law.rate_exponent, "of 1 or more");
    require(law.kinematic_fraction >= 0 && law.kinematic_fraction <= 1, m, "the kinematic fraction", law.kinematic_fraction, "from 0 to 1");
}

void check_curve(const Material& m, const CurvePlastic::Curve& curve)
{
    if (curve.points.empty() || curve.points.front().plastic_strain != 0)
        throw InputError(fmt::format("material '{}': a curve does not begin at plastic strain 0", m.name),
                         "give its first point as [0, yield stress]");
    require(curve.points.front().stress > 0, m, "the first stress of a curve", curve.points.front().stress, "above 0 Pa");
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const auto &a = curve.points[i - 1], &b = curve.points[i];
        require(b.plastic_strain > a.plastic_strain, m, "a plastic strain of a curve", b.plastic_strain, "above the one before it");
        require(b.stress >= a.stress, m, "a stress of a curve", b.stress,
                "not below the one before it (softening is not a law of strength)");
    }
}

void check_law(const Material& m, const CurvePlastic& law)
{
    if (law.curves.empty())
        throw InputError(fmt::format("material '{}' has no curve", m.name), "give at least one curve of stress over plastic strain");
    for (const CurvePlastic::Curve& curve : law.curves) check_curve(m, curve);
    for (std::size_t i = 0; i < law.curves.size() && law.curves.size() > 1; ++i) {
        const double rate = law.curves[i].rate;
        require(rate > (i == 0 ? 0.0 : law.curves[i - 1].rate), m, "the rate of a curve", rate,
                "above 0 1/s and above that of the curve before it");
    }
    for (std::size_t i = 1; i < law.curves.size(); ++i)
        for (const CurvePlastic::Point& p : law.curves[i].points)
            require(p.stress >= law.yield_stress(p.plastic_strain, law.curves[i - 1].rate, 0.0), m, "a stress of a faster curve", p.stress,
                    "not below that of the slower one");
    require(law.rate_constant >= 0, m, "the rate constant C", law.rate_constant, "of 0 1/s (no rate effect) or more");
    require(law.rate_exponent >= 1, m, "the rate exponent p", law.rate_exponent, "of 1 or more");
}

void check_law(const Material& m, const JohnsonCook& law)
{
    require(law.a > 0, m, "A", law.a, "above 0 Pa");
    require(law.b >= 0, m, "B", law.b, "of 0 Pa or more");
    require(law.n > 0, m, "n", law.n, "above 0");
    require(law.c >= 0, m, "C", law.c, "of 0 or more");
    require(law.reference_rate > 0, m, "the reference rate", law.reference_rate, "above 0 1/s");
    require(law.m > 0, m, "m", law.m, "above 0");
    require(law.melting_temperature > law.room_temperature, m, "the melting temperature", law.melting_temperature,
            "above room temperature");
    require(law.heat_capacity >= 0, m, "the heat capacity", law.heat_capacity, "of 0 J/(m3 K) (nothing warms up) or more");
    require(law.heat_share >= 0 && law.heat_share <= 1, m, "the share of plastic work that heats", law.heat_share, "from 0 to 1");
    if (law.fails()) require(law.d1 + law.d2 > 0, m, "D1 + D2", law.d1 + law.d2, "above 0, or all of D1 to D5 as 0");
}

void check_law(const Material& m, const HydroPlastic& law)
{
    check_law(m, law.deviator);
    require(law.density == m.density, m, "the density of the equation of state", law.density, "equal to the material's");
    require(law.sound_speed > 0, m, "the speed of sound c0", law.sound_speed, "above 0 m/s");
    require(law.slope >= 0, m, "the slope s", law.slope, "of 0 or more");
    require(law.grueneisen >= 0, m, "the Grueneisen constant", law.grueneisen, "of 0 or more");
    require(law.tension_limit > 0, m, "the tension limit", law.tension_limit, "above 0 Pa");
}

void check_law(const Material&, const Fabric&) {}

}  // namespace

void check(const Material& m)
{
    require(m.density > 0, m, "the density", m.density, "above 0 kg/m3");
    require(m.young_modulus > 0, m, "Young's modulus", m.young_modulus, "above 0 Pa");
    require(m.poisson_ratio > -1 && m.poisson_ratio < 0.5, m, "Poisson's ratio", m.poisson_ratio, "above -1 and below 0.5");
    std::visit([&m](const auto& law) { check_law(m, law); }, m.strength);
}

}  // namespace corpuscle
