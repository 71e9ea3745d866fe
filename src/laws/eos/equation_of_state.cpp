#include "laws/eos/equation_of_state.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// Says which constant of which gas is wrong and what would be right; a NaN is wrong too.
void require(bool right, const std::string& owner, const char* constant, double value, const char* range)
{
    if (right) return;
    throw InputError(fmt::format("{}: {} = {:g} is outside {}", owner, constant, value, range),
                     fmt::format("give {} within {}", constant, range));
}

void check_law(const IdealGas& law, const std::string& owner)
{
    require(law.gamma > 1 && law.gamma <= 5.0 / 3 + 1e-12, owner, "gamma", law.gamma, "1 < gamma <= 5/3");
}

void check_law(const NobleAbel& law, const std::string& owner)
{
    require(law.gamma > 1 && law.gamma <= 5.0 / 3 + 1e-12, owner, "gamma", law.gamma, "1 < gamma <= 5/3");
    require(law.co_volume >= 0 && law.co_volume < 1, owner, "co_volume", law.co_volume, "0 <= co_volume < 1");
    require(law.reference_density > 0, owner, "reference_density", law.reference_density, "reference_density > 0");
}

void check_law(const Jwl& law, const std::string& owner)
{
    require(law.omega > 0 && law.omega <= 2.0 / 3 + 1e-12, owner, "omega", law.omega, "0 < omega <= 2/3");
    require(law.r1 > 0, owner, "R1", law.r1, "R1 > 0");
    require(law.r2 > 0, owner, "R2", law.r2, "R2 > 0");
    require(law.a >= 0, owner, "A", law.a, "A >= 0");
    require(std::isfinite(law.b), owner, "B", law.b, "finite numbers");
    require(law.reference_density > 0, owner, "reference_density", law.reference_density, "reference_density > 0");
}

}  // namespace

double heat_capacity_ratio(const EquationOfState& law)
{
    return std::visit([](const auto& own) { return own.heat_capacity_ratio(); }, law);
}

double largest_density(const EquationOfState& law)
{
    return std::visit([](const auto& own) { return own.largest_density(); }, law);
}

double virial_pressure(const EquationOfState& law, double density, double kinetic_pressure)
{
    return std::visit([&](const auto& own) { return own.virial_pressure(density, kinetic_pressure); }, law);
}

double pressure(const EquationOfState& law, double density, double energy)
{
    return std::visit([&](const auto& own) { return own.pressure(density, energy); }, law);
}

double energy(const EquationOfState& law, double density, double pressure)
{
    return std::visit([&](const auto& own) { return own.energy(density, pressure); }, law);
}

double sound_speed(const EquationOfState& law, double density, double energy)
{
    return std::visit([&](const auto& own) { return own.sound_speed(density, energy); }, law);
}

std::string law_name(const EquationOfState& law)
{
    constexpr const char* names[] = {"ideal", "noble_abel", "jwl"};
    static_assert(std::variant_size_v<EquationOfState> == 3);
    return names[law.index()];
}

void check(const EquationOfState& law, const std::string& owner)
{
    std::visit([&](const auto& own) { check_law(own, owner); }, law);
}

}  // namespace corpuscle
