#include "simulation/structure_pace.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

constexpr double nearly = 1e-9;              ///< of a step: what rounding makes of its end
constexpr double most_steps = 100;           ///< of one body within one step of the other
constexpr double particles_an_element = 10;  ///< whose step costs as much as an element's

/// What a second of the run costs, in steps of a particle: steps of `duration` [s] with `count` of the structure in each.
double cost(const Model& model, double duration, double count)
{
    const double gas = static_cast<double>(model.gas.particles.size() - model.gas.sleeping.particles + model.euler.cells());
    return (gas + count * particles_an_element * static_cast<double>(model.structure.element_count())) / duration;
}

/// How many even pieces, none longer than `longest`, make up a duration.
double pieces(double duration, double longest)
{
    return std::max(1.0, std::ceil(duration / longest - nearly));
}

}  // namespace

/// The structure's own step. It is kept as long as it is neither too long nor much too short: central difference stays stable while its
/// step is steady, but a step that wavers from one to the next can pump the structure's highest modes.
double StructurePace::own_step()
{
    constexpr double margin = 0.95, slack = 1.25;
    const double allowed = stable_step(model_.structure);
    if (steady_step_ > allowed || allowed > slack * steady_step_) steady_step_ = margin * allowed;
    return steady_step_;
}

/// A step of the gas with several of the structure in it: the gas's, or a shorter one of a whole number of the structure's longest if that
/// costs less a second.
double StructurePace::whole_steps(double gas, double own) const
{
    const double longest = std::min(gas, most_steps * own), fewer = std::floor(longest / own + nearly);
    return cost(model_, fewer * own, fewer) <= cost(model_, longest, pieces(longest, own)) ? fewer * own : longest;
}

double StructurePace::fit(double time, double gas, double left)
{
    span_ = 0;
    planned_ = 0;
    sets_step_ = false;
    const double ahead = clock_.time() - time;
    if (ahead > nearly * clock_.duration()) return ahead / pieces(ahead, gas);
    const double own = own_step();
    if (std::isfinite(gas) && std::isfinite(own) && own >= 2 * gas) {
        planned_ = 1;
        span_ = std::min(gas * std::min(std::floor(own / gas + nearly), most_steps), left);
        return span_ / pieces(span_, gas);
    }
    const double either = std::isfinite(own) ? own : model_.end_time / 1000;
    const double most = !std::isfinite(gas) ? either : own >= gas ? gas : whole_steps(gas, own);
    const double duration = std::min(most, left);
    planned_ = std::isfinite(own) ? static_cast<int>(pieces(duration, own)) : 1;
    sets_step_ = most < gas;
    return duration;
}

void StructurePace::advance(const Clock& clock, Phases& phases)
{
    Nodes& nodes = model_.structure.nodes;
    if (planned_ == 0) {
        nodes.path_start = nodes.path_end;
    } else if (planned_ > 1) {
        nodes.path_start = nodes.position;
    } else {
        nodes.path_start.clear();
    }
    const double duration = span_ > 0 ? span_ : clock.duration() / std::max(1, planned_);
    for (int i = 0; i < planned_; ++i) step(duration, phases);
    if (planned_ > 0 && !(span_ > 0)) clock_.restore(clock.end(), clock_.duration(), clock_.previous_duration(), clock_.step());
    show_path(clock);
}

/// One step of central difference.
void StructurePace::step(double duration, Phases& phases)
{
    Ledger& ledger = model_.ledger;
    clock_.begin_step(duration);
    phases.time("accelerate", [&] { ledger.add(accelerate(model_.structure, clock_)); });
    phases.time("resist", [&] { ledger.add(resist(model_.structure, clock_)); });
    phases.time("load", [&] {
        for (const auto& load : model_.loads) ledger.add(load->apply(clock_));
    });
    clock_.end_step();
}

/// Where the nodes are when the gas's step ends: on their way, if the structure is ahead.
void StructurePace::show_path(const Clock& clock) const
{
    Nodes& nodes = model_.structure.nodes;
    const double ahead = clock_.time() - clock.end();
    if (!(ahead > nearly * clock_.duration())) return nodes.path_end.clear();
    const double back = ahead / clock_.duration();
    nodes.path_end.resize(nodes.size());
    for_each(nodes.size(), [&](std::size_t i) { nodes.path_end[i] = nodes.position[i] + back * (nodes.previous[i] - nodes.position[i]); });
}

FieldSet StructurePace::state()
{
    constexpr std::size_t count = 5;
    Field field{"numbers", "s, 1", "time, step, step before and steps of the structure; its steady step", Scalar::float64, 1, count,
                {},        {}};
    field.gather = [this](void* out) {
        const std::array<double, count> numbers{clock_.time(), clock_.duration(), clock_.previous_duration(),
                                                static_cast<double>(clock_.step()), steady_step_};
        std::copy(numbers.begin(), numbers.end(), static_cast<double*>(out));
    };
    field.restore = [this](const void* in, std::size_t) {
        const double* from = static_cast<const double*>(in);
        clock_.restore(from[0], from[1], from[2], static_cast<std::uint64_t>(from[3]));
        steady_step_ = from[4];
    };
    return {"structure_pace", {std::move(field)}};
}

}  // namespace corpuscle
