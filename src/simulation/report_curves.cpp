#include "simulation/report_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "simulation/report_text.hpp"
#include "simulation/summary_history.hpp"

namespace corpuscle {

namespace {

constexpr double negligible = 1e-3;   ///< of the greatest value, for a component
constexpr double small_share = 0.05;  ///< of the greatest value, for an energy
constexpr double sigmas = 1.959964;   ///< of a normal law that hold 95 % of it
constexpr std::array<std::string_view, 5> order{"displacement", "energy", "pressure", "impulse", "velocity"};

/// Columns that share a chart.
struct Group {
    std::string quantity;
    std::string unit;
    std::vector<std::size_t> columns;
};

std::string group_quantity(const HistoryColumn& column)
{
    const ColumnName name = column_name(column.name);
    return name.owner == "energy" ? "energy" : name.quantity;
}

std::size_t rank(const Group& group)
{
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), group.quantity) - order.begin());
}

/// Columns that only say how sure another is: they belong to its curve.
std::set<std::string> companions_in(const HistoryTable& history)
{
    std::set<std::string> names;
    for (const HistoryColumn& column : history.columns)
        for (const char* kind : {"error", "deviation", "low", "high"}) names.insert(companion(column.name, kind));
    return names;
}

std::vector<Group> groups_of(const HistoryTable& history)
{
    std::vector<Group> groups;
    const std::set<std::string> companions = companions_in(history);
    for (std::size_t i = 0; i < history.columns.size(); ++i) {
        if (companions.contains(history.columns[i].name)) continue;
        const std::string quantity = group_quantity(history.columns[i]);
        const std::string& unit = history.columns[i].unit;
        auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& group) { return group.quantity == quantity && group.unit == unit; });
        if (found == groups.end()) found = groups.insert(groups.end(), Group{quantity, unit, {}});
        found->columns.push_back(i);
    }
    std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
        return std::tuple(rank(a), a.quantity, a.unit) < std::tuple(rank(b), b.quantity, b.unit);
    });
    return groups;
}

double greatest(const std::vector<double>& values)
{
    double result = 0;
    for (const double value : values) {
        if (std::isfinite(value)) result = std::max(result, std::abs(value));
    }
    return result;
}

/// "center z", "gas" (of the energies), "wall".
std::string curve_label(const std::string& column)
{
    const ColumnName name = column_name(column);
    if (name.owner == "energy") return spaced(name.quantity + (name.component.empty() ? "" : "_" + name.component));
    const std::string owner = name.owner.empty() ? spaced(name.quantity) : name.owner;
    return name.component.empty() ? owner : owner + " " + name.component;
}

/// A history's column as a curve, with its band if the history knows one.
Curve curve_of(const HistoryTable& history, std::size_t column)
{
    const std::string& name = history.columns[column].name;
    Curve curve{curve_label(name), history.times, history.values[column], {}};
    const std::vector<double>*low = history.find(companion(name, "low")), *high = history.find(companion(name, "high"));
    const std::vector<double>* error = history.find(companion(name, "error"));
    if (low != nullptr && high != nullptr) {
        curve.band = {*low, *high};
    } else if (error != nullptr) {
        for (std::size_t i = 0; i < curve.y.size(); ++i) {
            curve.band.low.push_back(curve.y[i] - sigmas * (*error)[i]);
            curve.band.high.push_back(curve.y[i] + sigmas * (*error)[i]);
        }
    }
    if (!curve.band.low.empty()) curve.label += " (band: 95 %)";
    return curve;
}

/// Where in the group the gauge's own curve is, if a column is what Kingery and Bulmash say of its place.
std::optional<std::size_t> gauge_beside(const Group& group, const HistoryTable& history, std::size_t column)
{
    const std::string owner = column_name(history.columns[column].name).owner;
    for (std::size_t k = 0; k < group.columns.size(); ++k)
        if (owner == kingery_bulmash_name(column_name(history.columns[group.columns[k]].name).owner)) return k;
    return {};
}

Chart chart_of(const Group& group, const HistoryTable& history, const std::vector<ReferenceValue>& references)
{
    Chart chart{capitalized(spaced(group.quantity)), "time", "s", spaced(group.quantity), group.unit, {}, {}};
    double size = 0;
    for (const std::size_t i : group.columns) size = std::max(size, greatest(history.values[i]));
    for (const std::size_t i : group.columns) {
        const std::string& column = history.columns[i].name;
        const bool component = !column_name(column).component.empty();
        for (const ReferenceValue& reference : references) {
            if (reference.column == column) chart.references.push_back({reference.value, reference.label});
        }
        if (component && size > 0 && greatest(history.values[i]) < negligible * size) continue;
        chart.curves.push_back(curve_of(history, i));
        chart.curves.back().beside = gauge_beside(group, history, i);
    }
    return chart;
}

/// Moves the curves that would lie on the axis beside the great ones into a chart of their own: what a plate takes up is a small part of
/// what an explosive holds.
Chart lesser_curves(Chart& chart)
{
    double size = 0;
    for (const Curve& curve : chart.curves) size = std::max(size, greatest(curve.y));
    Chart lesser = chart;
    lesser.title += ", the smaller shares";
    lesser.references.clear();
    lesser.curves.clear();
    std::vector<Curve> kept;
    for (Curve& curve : chart.curves) (greatest(curve.y) >= small_share * size ? kept : lesser.curves).push_back(std::move(curve));
    chart.curves = std::move(kept);
    return lesser;
}

}  // namespace

std::vector<Chart> history_charts(const HistoryTable& history, const std::vector<ReferenceValue>& references)
{
    std::vector<Chart> charts;
    for (const Group& group : groups_of(history)) {
        charts.push_back(chart_of(group, history, references));
        if (group.quantity != "energy") continue;
        Chart lesser = lesser_curves(charts.back());
        const bool flat =
            std::all_of(lesser.curves.begin(), lesser.curves.end(), [](const Curve& curve) { return greatest(curve.y) == 0; });
        if (!flat) charts.push_back(std::move(lesser));
    }
    return charts;
}

}  // namespace corpuscle
