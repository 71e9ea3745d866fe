#include "simulation/ensemble_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "math/statistics.hpp"
#include "simulation/summary_history.hpp"

namespace corpuscle {

namespace {

constexpr double same_time = 1e-9;  ///< of the end time: closer times share a row

/// A column's samples, in time.
struct Samples {
    std::vector<double> times;
    std::vector<double> values;
};

Samples samples_of(const HistoryTable& history, const std::string& column)
{
    Samples samples;
    const std::vector<double>* values = history.find(column);
    if (values == nullptr) return samples;
    for (std::size_t i = 0; i < values->size(); ++i) {
        if (std::isnan((*values)[i])) continue;
        samples.times.push_back(history.times[i]);
        samples.values.push_back((*values)[i]);
    }
    return samples;
}

/// The value at a time, straight between the samples; the first and the last one beyond them.
double interpolated(const Samples& samples, double time)
{
    if (samples.times.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto after = std::lower_bound(samples.times.begin(), samples.times.end(), time);
    if (after == samples.times.begin()) return samples.values.front();
    if (after == samples.times.end()) return samples.values.back();
    const auto i = static_cast<std::size_t>(after - samples.times.begin());
    const double share = (time - samples.times[i - 1]) / (samples.times[i] - samples.times[i - 1]);
    return samples.values[i - 1] + share * (samples.values[i] - samples.values[i - 1]);
}

std::vector<double> at_moments(const Samples& samples, const std::vector<double>& times)
{
    std::vector<double> values;
    for (const double time : times) values.push_back(interpolated(samples, time));
    return values;
}

/// Means over the intervals that end at the times, of samples that are means since the sample before. The first is taken as it is.
std::vector<double> over_intervals(const Samples& samples, const std::vector<double>& times)
{
    Samples integral{samples.times, {}};
    for (std::size_t i = 0; i < samples.times.size(); ++i)
        integral.values.push_back(i == 0 ? 0 : integral.values.back() + samples.values[i] * (samples.times[i] - samples.times[i - 1]));
    std::vector<double> values{interpolated(samples, times.front())};
    for (std::size_t k = 1; k < times.size(); ++k)
        values.push_back((interpolated(integral, times[k]) - interpolated(integral, times[k - 1])) / (times[k] - times[k - 1]));
    return values;
}

/// Pressure and force of gauges that count hits; one in the gas shows its state at a moment, its density too.
bool is_mean_since_last(const HistoryTable& history, const std::string& column)
{
    const ColumnName name = column_name(column);
    return (name.quantity == "pressure" || name.quantity == "force") && history.find(name.owner + ".density") == nullptr;
}

/// Columns that are the standard error of another.
std::set<std::string> error_columns(const HistoryTable& history)
{
    std::set<std::string> names;
    for (const HistoryColumn& column : history.columns) names.insert(companion(column.name, "error"));
    return names;
}

/// The statistics of one column at its times.
std::vector<Statistic> statistics_of(const std::vector<HistoryTable>& members, const std::string& column, const std::vector<double>& times)
{
    std::vector<std::vector<double>> values;
    const bool mean = is_mean_since_last(members.front(), column);
    for (const HistoryTable& member : members) {
        const Samples samples = samples_of(member, column);
        values.push_back(mean ? over_intervals(samples, times) : at_moments(samples, times));
    }
    std::vector<Statistic> statistics;
    for (std::size_t k = 0; k < times.size(); ++k) {
        std::vector<double> at_time;
        for (const std::vector<double>& member : values) at_time.push_back(member[k]);
        statistics.push_back(statistic_of(at_time));
    }
    return statistics;
}

/// All times of all columns, once each.
std::vector<double> rows_of(const HistoryTable& history, const SampleTimes& times)
{
    std::vector<double> rows;
    for (const HistoryColumn& column : history.columns) {
        const std::vector<double> own = times.of(column_name(column.name).owner);
        rows.insert(rows.end(), own.begin(), own.end());
    }
    std::sort(rows.begin(), rows.end());
    const double close = same_time * times.end;
    rows.erase(std::unique(rows.begin(), rows.end(), [close](double a, double b) { return b - a <= close; }), rows.end());
    return rows;
}

/// Adds the four columns of a statistic, empty in the rows of other columns.
void add_columns(HistoryTable& table, const HistoryColumn& column, const std::vector<double>& times, const std::vector<Statistic>& found,
                 double close)
{
    const std::vector<double> empty(table.times.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::vector<double>> values(4, empty);
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto row = std::lower_bound(table.times.begin(), table.times.end(), times[k] - close) - table.times.begin();
        const std::array<double, 4> shown{found[k].mean, found[k].deviation, found[k].low, found[k].high};
        for (std::size_t i = 0; i < shown.size(); ++i) values[i][static_cast<std::size_t>(row)] = shown[i];
    }
    table.columns.push_back(column);
    for (const char* kind : {"deviation", "low", "high"}) table.columns.push_back({companion(column.name, kind), column.unit});
    for (std::vector<double>& list : values) table.values.push_back(std::move(list));
}

}  // namespace

std::vector<double> SampleTimes::of(const std::string& owner) const
{
    const auto own = every.find(owner);
    const double interval = own == every.end() ? otherwise : own->second;
    std::vector<double> times;
    if (interval > 0)
        for (double k = 0; k * interval < end * (1 - same_time); ++k) times.push_back(k * interval);
    if (times.empty()) times.push_back(0);
    times.push_back(end);
    return times;
}

HistoryTable ensemble_history(const std::vector<HistoryTable>& members, const SampleTimes& times)
{
    HistoryTable table;
    if (members.empty()) return table;
    const HistoryTable& first = members.front();
    const std::set<std::string> errors = error_columns(first);
    table.times = rows_of(first, times);
    for (const HistoryColumn& column : first.columns) {
        if (errors.contains(column.name)) continue;
        const std::vector<double> own = times.of(column_name(column.name).owner);
        add_columns(table, column, own, statistics_of(members, column.name, own), same_time * times.end);
    }
    return table;
}

}  // namespace corpuscle
