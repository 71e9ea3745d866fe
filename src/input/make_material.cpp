#include "input/make_material.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// How a material is called in messages.
std::string name_of(const MaterialValues& material)
{
    return material.name.empty() ? "unnamed" : material.name;
}

/// Refuses the constant C of Cowper and Symonds without its exponent p.
void check_rate(const MaterialValues& material, double rate_c, double rate_p)
{
    if (rate_c > 0 && !(rate_p >= 1))
        throw InputError(fmt::format("material '{}' has rate_c but rate_p = {}", name_of(material), rate_p),
                         "expected rate_p >= 1 beside rate_c", material.places.own);
}

BilinearPlastic bilinear(const MaterialValues& material, const BilinearValues& b)
{
    check_rate(material, b.rate_c, b.rate_p);
    return {b.yield_stress, b.hardening_modulus, b.rate_c, std::max(1.0, b.rate_p), b.kinematic};
}

CurvePlastic curve(const MaterialValues& material, const CurveValues& values)
{
    check_rate(material, values.rate_c, values.rate_p);
    CurvePlastic law;
    law.rate_constant = values.rate_c;
    law.rate_exponent = std::max(1.0, values.rate_p);
    for (const CurveLine& line : values.curves) {
        if (line.plastic_strain.size() != line.stress.size())
            throw InputError(fmt::format("material '{}': a curve has {} plastic strains and {} stresses", name_of(material),
                                         line.plastic_strain.size(), line.stress.size()),
                             "expected one stress for each plastic strain", material.places.own);
        CurvePlastic::Curve& to = law.curves.emplace_back();
        to.rate = line.rate;
        for (std::size_t i = 0; i < line.stress.size(); ++i) to.points.push_back({line.plastic_strain[i], line.stress[i]});
    }
    return law;
}

JohnsonCook johnson_cook(const MaterialValues& material, const JohnsonCookValues& v)
{
    JohnsonCook law;
    law.a = v.a;
    law.b = v.b;
    law.n = v.n;
    law.c = v.c;
    law.reference_rate = v.reference_rate;
    law.m = v.m;
    law.room_temperature = v.room_temperature;
    law.melting_temperature = v.melting_temperature;
    law.heat_capacity = material.density * v.specific_heat;
    law.heat_share = v.heat_share;
    law.d1 = v.d1;
    law.d2 = v.d2;
    law.d3 = v.d3;
    law.d4 = v.d4;
    law.d5 = v.d5;
    return law;
}

HydroPlastic hydro(const MaterialValues& material, const HydroValues& v)
{
    HydroPlastic law;
    law.deviator = {v.yield_stress, v.hardening_modulus, 0.0, 1.0, 0.0};
    law.density = material.density;
    law.sound_speed = v.sound_speed;
    law.slope = v.slope;
    law.grueneisen = v.grueneisen;
    if (v.tension_limit) law.tension_limit = *v.tension_limit;
    return law;
}

Strength strength_of(const MaterialValues& values)
{
    const StrengthValues& s = values.strength;
    if (s.bilinear) return bilinear(values, *s.bilinear);
    if (s.curve) return curve(values, *s.curve);
    if (s.johnson_cook) return johnson_cook(values, *s.johnson_cook);
    if (s.hydro) return hydro(values, *s.hydro);
    if (s.fabric) return Fabric{};
    return Elastic{};
}

}  // namespace

Material make_material(const MaterialValues& values)
{
    return {name_of(values), values.density, values.young_modulus, values.poisson_ratio, strength_of(values)};
}

}  // namespace corpuscle
