#include "input/known_blast.hpp"

#include <algorithm>
#include <cmath>

#include "input/gas_states.hpp"
#include "input/shapes.hpp"

namespace corpuscle {

namespace {

constexpr double tnt_energy = 7e9 / 1630;  // per mass [J/kg], share/explosives/tnt.toml
constexpr double open_air = 101325;        // [Pa]
constexpr double of_open_air = 0.05;       // may its pressure differ by, relative

/// Pressure of the gas all around, if there is one [Pa].
std::optional<double> ambient_pressure(const CaseDescription& description)
{
    const std::optional<Preset<GasValues>>& fill = description.gas ? description.gas->fill : description.euler->fill;
    if (!fill) return {};
    const double pressure = usual_state(*fill->values).pressure;
    return std::abs(pressure / open_air - 1) < of_open_air ? std::optional(pressure) : std::nullopt;
}

/// Whether a hemisphere at `center` that points along `axis` lies flat on a rigid face of the box.
bool lies_on_ground(const CaseDescription& description, const Vector3d& center, const Vector3d& axis)
{
    if (!description.gas) return false;
    const std::array<const std::array<Edge, 2>*, 3> edges{&description.gas->edges.x, &description.gas->edges.y, &description.gas->edges.z};
    for (int a = 0; a < 3; ++a) {
        const std::size_t side = axis[a] > 0 ? 0 : 1, along = static_cast<std::size_t>(a);
        const std::array<double, 2>& range = description.gas->box[along];
        const bool points = std::abs(axis[a]) > (1 - 1e-9) * norm(axis);
        if (points && (*edges[along])[side] == Edge::rigid && std::abs(center[a] - range[side]) < 1e-9 * (range[1] - range[0])) return true;
    }
    return false;
}

/// Where and how the charge bursts.
struct BurstPlace {
    Vector3d center;
    Burst burst = Burst::spherical;
};

std::optional<BurstPlace> burst_of(const CaseDescription& description, const ChargeInput& charge)
{
    const ShapeInput& shape = charge.shape;
    if (shape.sphere) return BurstPlace{shape.sphere->center};
    if (shape.form == ChargeForm::sphere && charge.center) return BurstPlace{*charge.center};
    const bool dome = shape.form == ChargeForm::hemisphere && charge.center;
    if (!shape.hemisphere && !dome) return {};
    const Vector3d center = dome ? *charge.center : shape.hemisphere->center, axis = dome ? charge.axis : shape.hemisphere->axis;
    if (!lies_on_ground(description, center, axis)) return {};
    return BurstPlace{center, Burst::hemispherical};
}

}  // namespace

std::optional<KnownBlast> known_blast(const CaseDescription& description)
{
    if (description.charges.size() != 1 || (!description.gas && !description.euler)) return {};
    const ChargeInput& charge = description.charges.front();
    const std::optional<double> ambient = ambient_pressure(description);
    const std::optional<BurstPlace> place = burst_of(description, charge);
    if (!ambient || !place) return {};
    const ExplosiveValues& explosive = *charge.explosive.values;
    KnownBlast blast;
    blast.mass = make_charge_shape(charge, description).volume() * explosive.energy_density / tnt_energy;
    blast.center = place->center;
    blast.burst = place->burst;
    blast.ambient = *ambient;
    for (std::size_t i = 0; i < charge.detonation.size(); ++i)
        blast.time = i == 0 ? charge.detonation[i].time : std::min(blast.time, charge.detonation[i].time);
    return blast;
}

}  // namespace corpuscle
