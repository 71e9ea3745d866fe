#include "simulation/summary_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace corpuscle {

namespace {

constexpr double arrival_share = 0.05, rounding = 1e-9;
constexpr double told_from_noise = 4;  ///< standard errors

/// Extremes of the samples that are there; nothing if there are none.
std::optional<ProbeSummary> extremes(const std::vector<double>& times, const std::vector<double>& values)
{
    std::optional<ProbeSummary> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i];
        if (std::isnan(value)) continue;
        if (!result) result = ProbeSummary{value, value, value, times[i], times[i]};
        if (value < result->minimum) {
            result->minimum = value;
            result->time_of_minimum = times[i];
        }
        if (value > result->maximum) {
            result->maximum = value;
            result->time_of_maximum = times[i];
        }
        result->final = value;
    }
    return result;
}

/// A column's value in the row of that time; not a number if there is none.
double value_at(const HistoryTable& history, const std::string& column, double time)
{
    const std::vector<double>* values = history.find(column);
    const auto row = std::find(history.times.begin(), history.times.end(), time);
    if (values == nullptr || row == history.times.end()) return std::numeric_limits<double>::quiet_NaN();
    return (*values)[static_cast<std::size_t>(row - history.times.begin())];
}

/// When a pressure first rises by a share of its greatest rise, and by more than still gas would by chance: the squared error of a sample
/// goes with its pressure, as that of a number of impacts does. Not a number if it never does. `errors`: of the pressures, or null.
double arrival(const std::vector<double>& times, const std::vector<double>& pressures, const std::vector<double>* errors, double peak)
{
    constexpr double never = std::numeric_limits<double>::quiet_NaN();
    const auto first = std::find_if(pressures.begin(), pressures.end(), [](double pressure) { return !std::isnan(pressure); });
    if (first == pressures.end() || !(peak - *first > rounding * std::abs(*first))) return never;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        const double rise = pressures[i] - *first;
        if (!(rise >= arrival_share * (peak - *first))) continue;
        const double error = errors != nullptr ? (*errors)[i] : 0.0;
        const double of_still_gas = error > 0 ? error * std::sqrt(std::max(0.0, *first) / pressures[i]) : 0.0;
        if (rise >= told_from_noise * of_still_gas) return times[i];
    }
    return never;
}

}  // namespace

ColumnName column_name(const std::string& name)
{
    ColumnName result;
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos) result.owner = name.substr(0, dot);
    result.quantity = dot == std::string::npos ? name : name.substr(dot + 1);
    const std::string& quantity = result.quantity;
    if (quantity.size() > 2 && quantity[quantity.size() - 2] == '_' && quantity.back() >= 'x' && quantity.back() <= 'z') {
        result.component = quantity.substr(quantity.size() - 1);
        result.quantity.resize(quantity.size() - 2);
    }
    return result;
}

std::string companion(const std::string& name, const std::string& kind)
{
    const ColumnName parts = column_name(name);
    return (parts.owner.empty() ? "" : parts.owner + ".") + parts.quantity + "_" + kind +
           (parts.component.empty() ? "" : "_" + parts.component);
}

void add_probes(RunSummary& summary, const HistoryTable& history, const std::vector<std::string>& probes)
{
    for (std::size_t i = 0; i < history.columns.size(); ++i) {
        const HistoryColumn& column = history.columns[i];
        const std::string owner = column_name(column.name).owner;
        const std::string kind = column_name(column.name).quantity;
        const bool probed = kind == "displacement" || kind == "velocity";  // a gauge of the same name has more
        if (!probed || std::find(probes.begin(), probes.end(), owner) == probes.end()) continue;
        const std::string quantity = column.name.substr(owner.empty() ? 0 : owner.size() + 1);
        if (const auto result = extremes(history.times, history.values[i]))
            summary.probes[owner][summary_key(quantity, column.unit)] = *result;
    }
}

std::string kingery_bulmash_name(const std::string& gauge)
{
    return gauge + " (Kingery-Bulmash)";
}

namespace {

std::optional<EmpiricalSummary> empirical_summary(const HistoryTable& history, const std::string& gauge)
{
    const std::string name = kingery_bulmash_name(gauge);
    const std::vector<double>*pressure = history.find(name + ".pressure"), *impulse = history.find(name + ".impulse");
    if (pressure == nullptr || impulse == nullptr) return {};
    const std::optional<ProbeSummary> peak = extremes(history.times, *pressure), pushed = extremes(history.times, *impulse);
    if (!peak || !pushed) return {};
    return EmpiricalSummary{peak->maximum, pushed->maximum, arrival(history.times, *pressure, nullptr, peak->maximum)};
}

}  // namespace

void add_gauges(RunSummary& summary, const HistoryTable& history, const std::vector<std::string>& gauges)
{
    for (const std::string& name : gauges) {
        const std::vector<double>* pressure = history.find(name + ".pressure");
        const std::vector<double>* impulse = history.find(name + ".impulse");
        if (pressure == nullptr) continue;
        const std::optional<ProbeSummary> seen = extremes(history.times, *pressure);
        if (!seen) continue;
        const double peak = seen->maximum;
        ProbeSummary pushed;
        if (impulse != nullptr) pushed = extremes(history.times, *impulse).value_or(ProbeSummary{});
        summary.gauges[name] = {peak,
                                pushed.maximum,
                                arrival(history.times, *pressure, history.find(name + ".pressure_error"), peak),
                                value_at(history, name + ".pressure_error", seen->time_of_maximum),
                                value_at(history, name + ".impulse_error", pushed.time_of_maximum),
                                empirical_summary(history, name)};
    }
}

}  // namespace corpuscle
