#include "simulation/grid_gauges.hpp"

#include <limits>
#include <string>

#include "model/grid_books.hpp"

namespace corpuscle {

namespace {

constexpr double universal_gas_constant = 8.31446261815324;  // [J/(mol K)], CODATA 2018

/// The gases in a region at one moment.
struct RegionState {
    double density = 0;      ///< [kg/m3]
    double pressure = 0;     ///< mean over the volume [Pa]
    Vector3d velocity;       ///< of the mass, in space [m/s]
    double temperature = 0;  ///< of all gases alike; not a number where a molar mass is not known [K]
};

/// Amount of substance in a cell [mol/m3]; not a number where a gas in it has no known molar mass.
double amount_in(const EulerGrid& grid, std::size_t cell)
{
    double amount = 0;
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        const double mass = grid.now.mass[m][cell], molar_mass = grid.materials[m].molar_mass;
        if (mass <= 1e-6 * grid.now.mass[0][cell] && molar_mass == 0) continue;  // a trace
        amount += molar_mass > 0 ? mass / molar_mass : std::numeric_limits<double>::quiet_NaN();
    }
    return amount;
}

RegionState look_into(const EulerGrid& grid, const GridRegionGauge& region)
{
    RegionState found;
    double volume = 0, amount = 0;
    Vector3d momentum;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
        const std::size_t c = region.cells[i];
        const EulerCell cell = look(grid, c);
        const double part = region.volumes[i];
        volume += part;
        found.density += part * cell.density;
        found.pressure += part * cell.pressure;
        momentum += part * cell.density * in_space(grid.space, cell.velocity);
        amount += part * amount_in(grid, c);
    }
    found.velocity = (1 / found.density) * momentum;
    found.temperature = found.pressure / (amount * universal_gas_constant);
    found.density /= volume;
    found.pressure /= volume;
    return found;
}

}  // namespace

GridGauges::GridGauges(const Model& model)
    : model_(model),
      time_(model.gauges.size(), model.start_time),
      impulse_(model.gauges.size()),
      first_(model.gauges.size()),
      last_(model.gauges.size())
{
}

void GridGauges::add_to(OutputPlan& plan, const Clock& clock)
{
    for (std::size_t index = 0; index < model_.gauges.size(); ++index) {
        const Gauge& gauge = model_.gauges[index];
        const bool face = std::holds_alternative<GridFaceGauge>(gauge.place);
        if (!face && !std::holds_alternative<GridRegionGauge>(gauge.place)) continue;
        HistorySource source;
        source.every = gauge.every;
        source.columns = {{gauge.name + ".pressure", "Pa"}, {gauge.name + ".impulse", "Pa s"}};
        if (face) {
            source.sample = [this, index, &clock](auto values) { sample_face(index, clock.end(), values); };
        } else {
            source.columns.push_back({gauge.name + ".density", "kg/m3"});
            source.columns.push_back({gauge.name + ".temperature", "K"});
            for (const char* axis : {"x", "y", "z"}) source.columns.push_back({gauge.name + ".velocity_" + axis, "m/s"});
            source.sample = [this, index, &clock](auto values) { sample_region(index, clock.end(), values); };
        }
        plan.history.push_back(std::move(source));
    }
}

/// Mean pressure since the last sample, by what was given to the face, and its specific impulse so far.
void GridGauges::sample_face(std::size_t index, double time, std::span<double> values)
{
    const int face = std::get<GridFaceGauge>(model_.gauges[index].place).face;
    const Vector3d given = model_.euler.passages[static_cast<std::size_t>(face)].momentum;
    const double impulse = (face % 2 == 0 ? -1 : 1) * given[face / 2] / face_area(model_.euler, face), passed = time - time_[index];
    values[0] = passed > 0 ? (impulse - impulse_[index]) / passed : std::numeric_limits<double>::quiet_NaN();
    values[1] = impulse;
    time_[index] = time;
    impulse_[index] = impulse;
}

/// State of a region; its impulse is that of the pressure above the one at the start.
void GridGauges::sample_region(std::size_t index, double time, std::span<double> values)
{
    const RegionState now = look_into(model_.euler, std::get<GridRegionGauge>(model_.gauges[index].place));
    if (time == model_.start_time) first_[index] = last_[index] = now.pressure;
    impulse_[index] += (0.5 * (last_[index] + now.pressure) - first_[index]) * (time - time_[index]);
    time_[index] = time;
    last_[index] = now.pressure;
    values[0] = now.pressure;
    values[1] = impulse_[index];
    values[2] = now.density;
    values[3] = now.temperature;
    values[4] = now.velocity.x;
    values[5] = now.velocity.y;
    values[6] = now.velocity.z;
}

FieldSet GridGauges::state()
{
    if (model_.gauges.empty()) return {"grid gauges", {}};
    return {"grid gauges",
            {stored_field("time", "s", "time of the last sample", time_),
             stored_field("impulse", "Pa s", "impulse at the last sample", impulse_),
             stored_field("first", "Pa", "pressure of a region at the start", first_),
             stored_field("last", "Pa", "pressure of a region at the last sample", last_)}};
}

}  // namespace corpuscle
