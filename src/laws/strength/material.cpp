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

}  // namespace

void check(const Material& m)
{
    require(m.density > 0, m, "the density", m.density, "above 0 kg/m3");
    require(m.young_modulus > 0, m, "Young's modulus", m.young_modulus, "above 0 Pa");
    require(m.poisson_ratio > -1 && m.poisson_ratio < 0.5, m, "Poisson's ratio", m.poisson_ratio, "above -1 and below 0.5");
    std::visit([&m](const auto& law) { check_law(m, law); }, m.strength);
}

}  // namespace corpuscle
