#include "simulation/gauges.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Half the cross product of a facet's edges, where its nodes are now [m2].
Vector3d area_vector(const Structure& structure, const Facet& facet)
{
    const std::vector<Vector3d>& at = structure.nodes.position;
    return 0.5 * cross(at[facet.node[1]] - at[facet.node[0]], at[facet.node[2]] - at[facet.node[0]]);
}

double part_area(const Structure& structure, std::uint32_t part)
{
    const std::vector<Facet>& facets = structure.surface.facets;
    return sum<double>(facets.size(), [&](std::size_t f) {
        const bool seen = facets[f].part == part && !structure.surface.is_hidden(f);
        return seen ? norm(area_vector(structure, facets[f])) : 0.0;
    });
}

double face_area(const Domain& domain, int face)
{
    const Vector3d size = domain.box.size();
    return size[(face / 2 + 1) % 3] * size[(face / 2 + 2) % 3];
}

/// Fills a source's columns one after the other.
class Columns {
public:
    explicit Columns(std::span<double> values) : values_(values) {}
    Columns& operator<<(double value)
    {
        values_[at_++] = value;
        return *this;
    }
    Columns& operator<<(const Vector3d& vector) { return *this << vector.x << vector.y << vector.z; }

private:
    std::span<double> values_;
    std::size_t at_ = 0;
};

/// Standard error of a variance; a variance may come out below 0 by rounding, or where a particle gave back what it had given.
double root(double variance)
{
    return std::sqrt(std::max(0.0, variance));
}

Vector3d roots(const Vector3d& v)
{
    return {root(v.x), root(v.y), root(v.z)};
}

/// "pressure" and "pressure_error" of each quantity, in this order.
void add_columns(HistorySource& source, const std::string& owner, std::initializer_list<HistoryColumn> quantities)
{
    for (const HistoryColumn& quantity : quantities) {
        source.columns.push_back({owner + "." + quantity.name, quantity.unit});
        source.columns.push_back({owner + "." + quantity.name + "_error", quantity.unit});
    }
}

/// The components of a vector, then those of its error.
void add_vector(HistorySource& source, const std::string& owner, const std::string& quantity, const std::string& unit)
{
    for (const char* kind : {"_x", "_y", "_z", "_error_x", "_error_y", "_error_z"})
        source.columns.push_back({owner + "." + quantity + kind, unit});
}

}  // namespace

Gauges::Gauges(const Model& model)
    : model_(model),
      time_(model.gauges.size(), model.start_time),
      impulse_(model.gauges.size()),
      variance_(model.gauges.size()),
      force_(model.gauges.size()),
      force_squares_(model.gauges.size()),
      first_(model.gauges.size()),
      first_error_(model.gauges.size()),
      last_(model.gauges.size()),
      last_error_(model.gauges.size()),
      trail_(model.gauges.size())
{
}

void Gauges::add_to(OutputPlan& plan, const Clock& clock)
{
    for (std::size_t index = 0; index < model_.gauges.size(); ++index) {
        const Gauge& gauge = model_.gauges[index];
        if (std::holds_alternative<GridFaceGauge>(gauge.place) || std::holds_alternative<GridRegionGauge>(gauge.place)) continue;
        HistorySource source;
        source.every = gauge.every;
        add_columns(source, gauge.name, {{"pressure", "Pa"}, {"impulse", "Pa s"}});
        if (const auto* part = std::get_if<PartGauge>(&gauge.place)) {
            add_vector(source, gauge.name, "force", "N");
            source.sample = [this, index, &clock, part](auto values) { sample_load(index, load_on(*part), clock.end(), values); };
        } else if (const auto* face = std::get_if<FaceGauge>(&gauge.place)) {
            source.sample = [this, index, &clock, face](auto values) { sample_load(index, load_on(*face), clock.end(), values); };
        } else {
            add_columns(source, gauge.name, {{"density", "kg/m3"}, {"kinetic_pressure", "Pa"}, {"temperature", "K"}});
            add_vector(source, gauge.name, "velocity", "m/s");
            source.columns.push_back({gauge.name + ".particles", "1"});
            source.sample = [this, index, &clock](auto values) { sample_region(index, clock.end(), values); };
        }
        plan.history.push_back(std::move(source));
    }
}

/// Gas and loads on both sides of a part; loads are given by formula and have no noise.
Gauges::Load Gauges::load_on(const PartGauge& gauge) const
{
    const Structure& structure = model_.structure;
    const std::vector<Facet>& facets = structure.surface.facets;
    Load load;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        if (facets[f].part != gauge.part) continue;
        Vector3d impulse = model_.gas_structure.facet_impulse()[f] + model_.grid_walls.facet_impulse()[f];
        for (const auto& other : model_.loads) impulse += other->facet_impulse()[f];
        const Vector3d& squares = model_.gas_structure.facet_squares()[f];
        load.impulse -= dot(impulse, normalized(area_vector(structure, facets[f])));
        load.squares += squares.x + squares.y + squares.z;
        load.force += impulse;
        load.squared += squares;
    }
    load.area = part_area(structure, gauge.part);
    return load;
}

/// What has bounced off a rigid face of the gas box.
Gauges::Load Gauges::load_on(const FaceGauge& gauge) const
{
    const FacePassages& passages = model_.gas.passages;
    const auto face = static_cast<std::size_t>(gauge.face);
    const double outward = gauge.face % 2 == 0 ? -1 : 1;
    Load load;
    load.area = face_area(model_.gas.domain, gauge.face);
    load.force = passages.face[face].momentum;
    load.impulse = outward * load.force[gauge.face / 2];
    load.squares = passages.squares[face];
    return load;
}

/// Means over the time since the last sample, and the impulse so far. A face has no columns for its force: it is pressure times area.
void Gauges::sample_load(std::size_t index, const Load& load, double time, std::span<double> values)
{
    const double passed = time - time_[index];
    const double rate = passed > 0 ? 1 / passed : 0;
    Columns columns(values);
    columns << rate * (load.impulse - impulse_[index]) / load.area << rate * root(load.squares - variance_[index]) / load.area;
    columns << load.impulse / load.area << root(load.squares) / load.area;
    if (std::holds_alternative<PartGauge>(model_.gauges[index].place))
        columns << rate * (load.force - force_[index]) << rate * roots(load.squared - force_squares_[index]);
    time_[index] = time;
    impulse_[index] = load.impulse;
    variance_[index] = load.squares;
    force_[index] = load.force;
    force_squares_[index] = load.squared;
}

/// State of the gas in a region; its impulse is that of the pressure above the one at the start.
void Gauges::sample_region(std::size_t index, double time, std::span<double> values)
{
    const RegionGauge& region = std::get<RegionGauge>(model_.gauges[index].place);
    const GasSample gas = sample(model_.gas, region.shape, region.volume);
    if (time == model_.start_time) {
        first_[index] = last_[index] = gas.pressure;
        first_error_[index] = last_error_[index] = gas.error.pressure;
    }
    integrate(index, gas, region.volume, time - time_[index]);
    time_[index] = time;
    const double of_first = (time - model_.start_time) * first_error_[index];
    Columns columns(values);
    columns << gas.pressure << gas.error.pressure << impulse_[index] << std::sqrt(variance_[index] + of_first * of_first);
    columns << gas.density << gas.error.density << gas.kinetic_pressure << gas.error.kinetic_pressure;
    columns << gas.temperature << gas.error.temperature << gas.velocity << gas.error.velocity << static_cast<double>(gas.particles);
}

/// Adds the impulse of an interval, and its variance. Samples of the same particles err alike: the correlation of two falls as
/// exp(-t/tau) with tau half the time that gas takes through the region, at its own and its thermal speed.
void Gauges::integrate(std::size_t index, const GasSample& gas, double volume, double passed)
{
    impulse_[index] += (0.5 * (last_[index] + gas.pressure) - first_[index]) * passed;
    const double thermal = gas.density > 0 ? std::sqrt(gas.pressure / gas.density) : 0;
    const double through = norm(gas.velocity) + thermal > 0 ? std::cbrt(volume) / (norm(gas.velocity) + thermal) : passed;
    const double term = 0.5 * (last_error_[index] + gas.error.pressure) * passed;
    trail_[index] *= std::exp(-2 * passed / through);
    variance_[index] += term * (term + 2 * trail_[index]);
    trail_[index] += term;
    last_[index] = gas.pressure;
    last_error_[index] = gas.error.pressure;
}

FieldSet Gauges::state()
{
    if (model_.gauges.empty()) return {"gauges", {}};
    return {
        "gauges",
        {stored_field("time", "s", "time of the last sample", time_), stored_field("impulse", "SI", "impulse at the last sample", impulse_),
         stored_field("variance", "SI", "of that impulse", variance_), stored_field("force", "N s", "impulse as a vector", force_),
         stored_field("force_squares", "N2 s2", "variance of that", force_squares_),
         stored_field("first", "Pa", "pressure of a region at the start", first_),
         stored_field("first_error", "Pa", "its standard error", first_error_),
         stored_field("last", "Pa", "pressure of a region at the last sample", last_),
         stored_field("last_error", "Pa", "its standard error", last_error_),
         stored_field("trail", "Pa s", "error of earlier samples that this one shares", trail_)}};
}

}  // namespace corpuscle
