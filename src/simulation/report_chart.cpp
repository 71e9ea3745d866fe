#include "simulation/report_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "simulation/report_text.hpp"
#include "simulation/report_units.hpp"

namespace corpuscle {

namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr double width = 520;
constexpr double height = 310;
constexpr double left = 62;
constexpr double right = 506;
constexpr double top = 14;
constexpr double bottom = 266;
constexpr std::size_t point_limit = 1200;
constexpr std::size_t colors = 8;  ///< as many as the style sheet has

/// One axis: SI values from low to high lie between two places of the drawing.
struct Axis {
    std::vector<double> ticks;  ///< as shown
    ShownUnit shown;
    double begin = 0;  ///< place of the lowest value
    double end = 0;    ///< place of the highest value

    [[nodiscard]] double low() const { return ticks.front(); }
    [[nodiscard]] double high() const { return ticks.back(); }
    /// Place of a value as shown.
    [[nodiscard]] double place(double value) const { return begin + (value - low()) / (high() - low()) * (end - begin); }
};

Axis make_axis(std::pair<double, double> range, const std::string& unit, int wanted)
{
    Axis axis;
    axis.shown = shown_unit(unit, std::max(std::abs(range.first), std::abs(range.second)));
    axis.ticks = axis_ticks(range.first / axis.shown.factor, range.second / axis.shown.factor, wanted);
    return axis;
}

/// A tick's number with as many decimals as the ticks' distance needs.
std::string tick_label(const Axis& axis, double tick)
{
    const double step = axis.ticks[1] - axis.ticks[0];
    if (step < 1e-4 || std::abs(tick) >= 1e6) return fmt::format("{:g}", tick);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return fmt::format("{:.{}f}", tick == 0 ? 0.0 : tick, decimals);
}

/// "time [ms]".
std::string axis_title(const std::string& name, const ShownUnit& shown)
{
    return shown.unit.empty() ? name : name + " [" + shown.unit + "]";
}

/// Adds the finite values to a range.
void widen(std::pair<double, double>& range, double value)
{
    if (!std::isfinite(value)) return;
    range.first = std::min(range.first, value);
    range.second = std::max(range.second, value);
}

/// The curves' thinned points, as shown.
std::vector<Points> shown_points(const std::vector<Points>& curves, const Axis& x, const Axis& y)
{
    std::vector<Points> result = curves;
    for (Points& points : result) {
        for (auto& [px, py] : points) {
            px /= x.shown.factor;
            py /= y.shown.factor;
        }
    }
    return result;
}

std::string grid(const Axis& x, const Axis& y)
{
    std::string text = "<g class=\"grid\">";
    for (const double tick : y.ticks)
        text += fmt::format("<path d=\"M{} {:.1f}H{}\"{}/>", left, y.place(tick), right, tick == 0 ? " class=\"zero\"" : "");
    for (const double tick : x.ticks) text += fmt::format("<path d=\"M{:.1f} {}v5\"/>", x.place(tick), bottom);
    text += "</g><g class=\"ticks\">";
    for (const double tick : y.ticks)
        text +=
            fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 7, y.place(tick) + 4.5, tick_label(y, tick));
    for (const double tick : x.ticks)
        text +=
            fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x.place(tick), bottom + 19, tick_label(x, tick));
    return text + "</g>";
}

/// Colour and stroke of a curve.
std::string line_class(const Chart& chart, std::size_t i)
{
    const std::optional<std::size_t>& beside = chart.curves[i].beside;
    return fmt::format("c{}{}", beside.value_or(i) % colors, beside || i >= colors ? " dashed" : "");
}

std::string paths(const Chart& chart, const std::vector<Points>& curves, const Axis& x, const Axis& y)
{
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::string path;
        for (const auto& [px, py] : curves[i])
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x.place(px), y.place(py));
        text += fmt::format("<path class=\"curve {}\" d=\"{}\"/>", line_class(chart, i), path);
    }
    return text;
}

/// The curves' bands: along their upper ends and back along the lower ones.
std::string bands(const Chart& chart, const Axis& x, const Axis& y)
{
    std::string text;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const Curve& curve = chart.curves[i];
        if (curve.band.low.empty()) continue;
        Points ends = thinned({"", curve.x, curve.band.high, {}}, point_limit);
        const Points low = thinned({"", curve.x, curve.band.low, {}}, point_limit);
        ends.insert(ends.end(), low.rbegin(), low.rend());
        std::string path;
        for (const auto& [px, py] : ends)
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x.place(px / x.shown.factor),
                           y.place(py / y.shown.factor));
        if (!path.empty()) text += fmt::format("<path class=\"band c{}\" d=\"{}Z\"/>", i % colors, path);
    }
    return text;
}

std::string reference_lines(const Chart& chart, const Axis& y)
{
    std::string text;
    for (const ReferenceLine& reference : chart.references) {
        const double place = y.place(reference.value / y.shown.factor);
        text += fmt::format(
            "<g class=\"reference\"><path d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}: {}</text></g>", left,
            place, right, right - 4, place > top + 20 ? place - 6 : place + 16, escaped(reference.label),
            escaped(shown_value(reference.value, chart.y_unit)));
    }
    return text;
}

std::string legend(const Chart& chart)
{
    std::string text = "<ul class=\"legend\">";
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        text += fmt::format("<li class=\"{}\">{}</li>", line_class(chart, i), escaped(chart.curves[i].label));
    }
    return text + "</ul>";
}

/// To six digits; what is too small for a double is 0.
double shortened(double value)
{
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

/// The points as JSON for the read-out: rounded to what the drawing shows.
std::string points_json(const Chart& chart, const std::vector<Points>& curves, const Axis& x, const Axis& y)
{
    nlohmann::json json{
        {"x", {x.low(), x.high(), left, right}}, {"y", {y.low(), y.high(), bottom, top}}, {"units", {x.shown.unit, y.shown.unit}}};
    json["names"] = nlohmann::json::array();
    json["curves"] = nlohmann::json::array();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        json["names"].push_back(chart.curves[i].label);
        nlohmann::json flat = nlohmann::json::array();
        for (const auto& [px, py] : curves[i]) {
            flat.push_back(shortened(px));
            flat.push_back(shortened(py));
        }
        json["curves"].push_back(std::move(flat));
    }
    std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    // "</script>" in a label must not end the block.
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) text.replace(at, 1, "\\u003c");
    return text;
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, int wanted)
{
    if (!(high > low)) {
        const double around = low == 0 ? 1 : std::abs(low);
        low -= around;
        high += around;
    }
    const double raw = (high - low) / std::max(wanted, 1);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double lead = raw / power;
    const double step = power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
    const double first = std::floor(low / step + 1e-9);
    const double last = std::ceil(high / step - 1e-9);
    std::vector<double> ticks;
    for (double count = first; count <= last; ++count) ticks.push_back(count * step);
    return ticks;
}

std::vector<std::pair<double, double>> thinned(const Curve& curve, std::size_t limit)
{
    Points points;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
        if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) points.emplace_back(curve.x[i], curve.y[i]);
    }
    if (points.size() <= limit) return points;
    const std::size_t slices = std::max<std::size_t>(limit / 4, 1);
    Points kept;
    for (std::size_t slice = 0; slice < slices; ++slice) {
        const std::size_t begin = points.size() * slice / slices;
        const std::size_t end = points.size() * (slice + 1) / slices;
        const auto by_value = [&points](std::size_t a, std::size_t b) { return points[a].second < points[b].second; };
        std::vector<std::size_t> indices(end - begin);
        for (std::size_t i = begin; i < end; ++i) indices[i - begin] = i;
        const auto [lowest, highest] = std::minmax_element(indices.begin(), indices.end(), by_value);
        std::vector<std::size_t> chosen{begin, *lowest, *highest, end - 1};
        std::sort(chosen.begin(), chosen.end());
        chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
        for (const std::size_t i : chosen) kept.push_back(points[i]);
    }
    return kept;
}

std::string drawn(const Chart& chart)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::pair<double, double> x_range{infinity, -infinity};
    std::pair<double, double> y_range{0, 0};
    std::vector<Points> curves;
    for (const Curve& curve : chart.curves) {
        curves.push_back(thinned(curve, point_limit));
        for (const auto& [px, py] : curves.back()) {
            widen(x_range, px);
            widen(y_range, py);
        }
        for (const double end : curve.band.low) widen(y_range, end);
        for (const double end : curve.band.high) widen(y_range, end);
    }
    for (const ReferenceLine& reference : chart.references) widen(y_range, reference.value);
    if (x_range.first > x_range.second) x_range = {0, 0};
    Axis x = make_axis(x_range, chart.x_unit, 6);
    Axis y = make_axis(y_range, chart.y_unit, 5);
    x.begin = left, x.end = right, y.begin = bottom, y.end = top;
    curves = shown_points(curves, x, y);
    return fmt::format(
        "<figure class=\"chart\"><figcaption><b>{0}</b> <span>{1}</span></figcaption>{2}"
        "<svg viewBox=\"0 0 {3} {4}\" role=\"img\" aria-label=\"{0} over {5}\">{6}{7}{8}"
        "<text class=\"axis\" x=\"{9}\" y=\"{10}\" text-anchor=\"middle\">{5}</text><g class=\"pointer\"></g></svg>"
        "<div class=\"tip\" hidden></div><script type=\"application/json\">{11}</script></figure>\n",
        escaped(chart.title), escaped(axis_title("", y.shown)), legend(chart), width, height, escaped(axis_title(chart.x_name, x.shown)),
        grid(x, y), reference_lines(chart, y), bands(chart, x, y) + paths(chart, curves, x, y), (left + right) / 2, height - 6,
        points_json(chart, curves, x, y));
}

}  // namespace corpuscle
