#include "simulation/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

#include "simulation/report_text.hpp"
#include "simulation/report_units.hpp"

namespace corpuscle {

namespace {

using Row = std::vector<std::string>;

/// A table in a card. The first cell of each row is its head; all cells are plain text.
std::string table(const std::string& caption, const Row& head, const std::vector<Row>& rows)
{
    if (rows.empty()) return {};
    std::string text = fmt::format("<div class=\"card scroll\"><table><caption>{}</caption>", escaped(caption));
    if (!head.empty()) {
        text += "<thead><tr>";
        for (const std::string& cell : head) text += "<th>" + escaped(cell) + "</th>";
        text += "</tr></thead>";
    }
    text += "<tbody>";
    for (const Row& row : rows) {
        text += "<tr><th scope=\"row\">" + escaped(row.front()) + "</th>";
        for (std::size_t i = 1; i < row.size(); ++i) text += "<td>" + escaped(row[i]) + "</td>";
        text += "</tr>";
    }
    return text + "</tbody></table></div>\n";
}

std::string tile(const std::string& value, const std::string& name)
{
    return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>", escaped(value), escaped(name));
}

/// A summary key taken apart again: "displacement_z_m" -> "displacement z" and "m".
struct KeyParts {
    std::string quantity;
    std::string unit;
};

KeyParts parts_of(const std::string& key)
{
    static const std::vector<std::pair<std::string, std::string>> units{{"_m_per_s2", "m/s2"},
                                                                        {"_m_per_s", "m/s"},
                                                                        {"_rad_per_s", "rad/s"},
                                                                        {"_kg_per_m3", "kg/m3"},
                                                                        {"_pa_s", "Pa s"},
                                                                        {"_n_s", "N s"},
                                                                        {"_n_m", "N m"},
                                                                        {"_pa", "Pa"},
                                                                        {"_j", "J"},
                                                                        {"_n", "N"},
                                                                        {"_k", "K"},
                                                                        {"_kg", "kg"},
                                                                        {"_rad", "rad"},
                                                                        {"_m", "m"},
                                                                        {"_s", "s"}};
    for (const auto& [suffix, unit] : units) {
        if (key.ends_with(suffix)) return {spaced(key.substr(0, key.size() - suffix.size())), unit};
    }
    return {spaced(key), "1"};
}

/// A place in summary.json in words: "/probes/center/displacement_z_m/max" -> "center displacement z, max" and "m".
struct QuantityName {
    std::string text;
    std::string unit;
};

QuantityName quantity_name(const std::string& place)
{
    std::vector<std::string> words;
    std::stringstream stream(place.substr(1));
    for (std::string word; std::getline(stream, word, '/');) words.push_back(word);
    if (words.size() < 3) return {place, "1"};
    const auto [quantity, unit] = parts_of(words[2]);
    std::string text = words[1] + " " + quantity, shown = unit;
    if (words.size() > 3 && words[0] == "parts") text += std::string(" ") + "xyz"[std::min<std::size_t>(words[3][0] - '0', 2)];
    if (words.size() > 3 && words[0] == "probes") {
        const bool time = words[3].starts_with("time_of");
        text += ", " + (time ? parts_of(words[3]).quantity : words[3]);
        if (time) shown = "s";
    }
    return {text, shown};
}

std::string particles_text(const RunSummary& summary)
{
    std::uint64_t total = 0;
    std::string species;
    for (const auto& [name, count] : summary.particles) {
        total += count;
        species += fmt::format("{}{} {}", species.empty() ? "" : ", ", grouped(count), name);
    }
    if (total == 0) return {};
    return fmt::format("{} particles{}", grouped(total),
                       summary.particles.size() > 1 ? " (" + species + ")" : " of " + summary.particles.begin()->first);
}

/// "1,234 particles of air, 12 elements and 3 cells".
std::string contents_text(const RunSummary& summary)
{
    std::vector<std::string> things;
    if (const std::string particles = particles_text(summary); !particles.empty()) things.push_back(particles);
    if (summary.elements > 0) things.push_back(grouped(summary.elements) + " elements");
    if (summary.grains > 0) things.push_back(grouped(summary.grains) + " grains");
    if (summary.cells > 0) things.push_back(grouped(summary.cells) + " cells");
    std::string text;
    for (std::size_t i = 0; i < things.size(); ++i) text += (i == 0 ? "" : i + 1 == things.size() ? " and " : ", ") + things[i];
    return text.empty() ? "nothing" : text;
}

std::string percent_of(double part, double whole)
{
    return whole > 0 ? fmt::format("{:.1f} %", 100 * part / whole) : "-";
}

std::string shown_bytes(std::uint64_t bytes)
{
    const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
    return mebibytes < 1024 ? rounded(mebibytes, 3) + " MiB" : rounded(mebibytes / 1024, 3) + " GiB";
}

/// Three components with one unit, each to a thousandth of the vector's size.
std::string shown_vector(const Vector3d& vector, const std::string& unit)
{
    const double size = norm(vector);
    const ShownUnit shown = shown_unit(unit, size);
    const int decimals = size > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size / shown.factor))), 0, 9) : 0;
    const auto value = [&](double si) {
        const std::string text = fmt::format("{:.{}f}", si / shown.factor, decimals);
        return text.find_first_not_of("-0.") == std::string::npos ? std::string("0") : text;
    };
    return fmt::format("({}, {}, {}) {}", value(vector.x), value(vector.y), value(vector.z), shown.unit);
}

std::string probe_table(const RunSummary& summary)
{
    std::vector<Row> rows;
    for (const auto& [name, quantities] : summary.probes) {
        for (const auto& [key, probe] : quantities) {
            const auto [quantity, unit] = parts_of(key);
            const ShownUnit shown = shown_unit(unit, std::max(std::abs(probe.minimum), std::abs(probe.maximum)));
            const auto value = [&shown](double si) { return rounded(si / shown.factor); };
            rows.push_back({name + " " + quantity, shown.unit, value(probe.minimum), shown_value(probe.time_of_minimum, "s"),
                            value(probe.maximum), shown_value(probe.time_of_maximum, "s"), value(probe.final)});
        }
    }
    return table("Probes", {"", "unit", "lowest", "at", "highest", "at", "last"}, rows);
}

std::string gauge_table(const RunSummary& summary)
{
    std::vector<Row> rows;
    for (const auto& [name, gauge] : summary.gauges) {
        rows.push_back({name, shown_value(gauge.peak_pressure, "Pa"), shown_value(gauge.peak_pressure_error, "Pa"),
                        shown_value(gauge.impulse, "Pa s"), shown_value(gauge.impulse_error, "Pa s"), shown_value(gauge.arrival, "s")});
        if (const auto& known = gauge.kingery_bulmash)
            rows.push_back({name + ", Kingery-Bulmash", shown_value(known->peak_pressure, "Pa"), "-", shown_value(known->impulse, "Pa s"),
                            "-", shown_value(known->arrival, "s")});
    }
    return table("Gauges", {"", "peak pressure", "standard error", "impulse", "standard error", "arrival"}, rows);
}

std::string part_table(const RunSummary& summary)
{
    std::vector<Row> rows;
    for (const auto& [name, part] : summary.parts) {
        rows.push_back({name, shown_vector(part.impulse, "N s"), shown_value(part.gas_work, "J"),
                        rounded(100 * part.max_plastic_strain, 3) + " %", shown_value(part.kinetic_energy, "J"),
                        shown_value(part.internal_energy, "J")});
    }
    return table("Parts", {"", "impulse taken up (x, y, z)", "work of gas", "plastic strain", "kinetic", "internal energy"}, rows);
}

std::string phase_table(const RunSummary& summary)
{
    const double known = std::accumulate(summary.seconds.begin(), summary.seconds.end(), 0.0,
                                         [](double sum, const auto& phase) { return sum + phase.second; });
    const double whole = std::max(summary.wall_seconds, known);
    if (!(whole > 0)) return {};
    std::vector<std::pair<std::string, double>> phases = summary.seconds;
    phases.emplace_back("other", whole - known);
    const double longest =
        std::max_element(phases.begin(), phases.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->second;
    std::string rows;
    for (const auto& [name, seconds] : phases) {
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td class=\"bar\"><div style=\"width:{:.1f}%\"></div></td></tr>",
            escaped(spaced(name)), escaped(shown_value(seconds, "s")), percent_of(seconds, whole), 100 * seconds / longest);
    }
    return "<div class=\"card scroll\"><table><caption>Wall time per phase</caption><tbody>" + rows + "</tbody></table></div>\n";
}

/// One line of the table of counts: how many, how much work, and what a unit of it took of the whole run.
Row work_row(const std::string& name, std::uint64_t count, std::uint64_t work, double wall)
{
    return {name, grouped(count), work > 0 ? grouped(work) : "-", work > 0 ? shown_value(wall / static_cast<double>(work), "s") : "-"};
}

std::string count_table(const RunSummary& summary)
{
    std::vector<Row> rows;
    std::uint64_t particles = 0;
    for (const auto& [name, count] : summary.particles) particles += count;
    const double wall = summary.wall_seconds;
    if (particles > 0) rows.push_back(work_row("particles", particles, summary.particle_steps, wall));
    for (const auto& [name, count] : summary.particles) rows.push_back({"of which " + name, grouped(count), "", ""});
    if (summary.elements > 0) rows.push_back(work_row("elements", summary.elements, summary.element_steps, wall));
    if (summary.grains > 0) rows.push_back(work_row("grains", summary.grains, summary.grain_steps, wall));
    if (summary.cells > 0) rows.push_back(work_row("cells", summary.cells, summary.cell_steps, wall));
    return table("Counts and work", {"", "number", "times steps", "wall time for each"}, rows);
}

}  // namespace

std::string report_header(const RunSummary& summary)
{
    const bool done = summary.status == "done";
    const std::string reason = summary.reason.empty() ? "" : fmt::format("<p class=\"warn\">{}</p>", escaped(summary.reason));
    return fmt::format(
        "<header><span class=\"status {}\">{}</span><h1>{}</h1>{}<p class=\"lead\">{} of time in {} steps, with {}: {} on {} "
        "thread{}.</p></header>\n",
        done ? "pass" : "warn", escaped(summary.status), escaped(summary.title), reason, escaped(shown_value(summary.end_time, "s")),
        grouped(summary.steps), escaped(contents_text(summary)), escaped(shown_value(summary.wall_seconds, "s")), summary.threads,
        summary.threads == 1 ? "" : "s");
}

std::string report_tiles(const RunSummary& summary)
{
    std::vector<std::string> tiles;
    for (const auto& [name, quantities] : summary.probes) {
        const ProbeSummary* largest = nullptr;
        std::string component;
        for (const auto& [key, probe] : quantities) {
            const auto size = [](const ProbeSummary& p) { return std::max(std::abs(p.minimum), std::abs(p.maximum)); };
            if (!key.starts_with("displacement") || (largest != nullptr && size(probe) <= size(*largest))) continue;
            largest = &probe;
            component = parts_of(key).quantity;
        }
        if (largest == nullptr) continue;
        const double value = std::abs(largest->minimum) > std::abs(largest->maximum) ? largest->minimum : largest->maximum;
        tiles.push_back(tile(shown_value(value, "m"), fmt::format("greatest {} of {}", component, name)));
    }
    for (const auto& [name, gauge] : summary.gauges) {
        tiles.push_back(tile(shown_value(gauge.peak_pressure, "Pa"), "peak pressure at " + name));
        tiles.push_back(tile(shown_value(gauge.impulse, "Pa s"), "impulse at " + name));
    }
    for (const auto& [name, part] : summary.parts) {
        if (norm(part.impulse) > 0) tiles.push_back(tile(shown_value(norm(part.impulse), "N s"), "impulse on " + name));
    }
    if (tiles.empty()) return {};
    std::string text = "<div class=\"tiles\">";
    for (std::size_t i = 0; i < std::min<std::size_t>(tiles.size(), 8); ++i) text += tiles[i];
    return text + "</div>\n";
}

std::string report_verdicts(const RunSummary& summary)
{
    std::string text = "<section><h2>Can it be trusted?</h2><div class=\"checks\">";
    for (const Verdict& verdict : all_verdicts(summary)) {
        const char* word = verdict.passed() ? "pass" : "warn";
        text += fmt::format(
            "<div class=\"card check {0}\"><b>{0}</b><h3>{1}</h3><div class=\"number\">{2}</div><p>limit {3}</p><p>{4}</p></div>", word,
            escaped(capitalized(verdict.name)), escaped(percentage(verdict.value)), escaped(percentage(verdict.limit)),
            escaped(verdict.meaning));
    }
    return text + "</div></section>\n";
}

std::string report_ensemble(const RunSummary& summary)
{
    if (!summary.ensemble) return {};
    const EnsembleSummary& ensemble = *summary.ensemble;
    std::vector<Row> rows;
    for (const auto& [place, statistic] : ensemble.quantities) {
        const QuantityName name = quantity_name(place);
        const ShownUnit shown = shown_unit(name.unit, std::abs(statistic.mean));
        const auto value = [&shown](double si) { return rounded(si / shown.factor); };
        rows.push_back({name.text, shown.unit, value(statistic.mean), value(statistic.standard_error), value(statistic.low),
                        value(statistic.high), value(statistic.deviation)});
    }
    const std::string said = fmt::format(
        "<p>{} of {} seeds ({} to {}) ran to the end. Curves and results are means; each run is in its own folder, seed_N. Bands and "
        "intervals hold the mean of infinitely many runs with 95 % confidence (Student's t).</p>",
        ensemble.done.size(), ensemble.seeds.size(), ensemble.seeds.front(), ensemble.seeds.back());
    return "<section><h2>Several seeds</h2>" + said +
           table("Means", {"", "unit", "mean", "standard error", "from", "to", "deviation of a run"}, rows) + "</section>\n";
}

std::string report_results(const RunSummary& summary)
{
    const std::string tables = probe_table(summary) + gauge_table(summary) + part_table(summary);
    return tables.empty() ? "" : "<section><h2>Results</h2><div class=\"stack\">" + tables + "</div></section>\n";
}

std::string report_ledger(const RunSummary& summary)
{
    std::vector<Row> rows;
    for (const Transfer& transfer : summary.transfers) {
        rows.push_back({transfer.from + " → " + transfer.to, transfer.mass == 0 ? "-" : rounded(transfer.mass) + " kg",
                        shown_vector(transfer.momentum, "N s"), shown_value(transfer.energy, "J")});
    }
    const std::string text = table("Sums over the run", {"", "mass", "momentum (x, y, z)", "energy"}, rows);
    return text.empty() ? "" : "<section><h2>Who gave what to whom</h2>" + text + "</section>\n";
}

std::string report_cost(const RunSummary& summary)
{
    const std::vector<Row> machine{{"wall time", shown_value(summary.wall_seconds, "s")},
                                   {"CPU time", shown_value(summary.cpu_seconds, "s")},
                                   {"threads", std::to_string(summary.threads)},
                                   {"processes", std::to_string(summary.ranks)},
                                   {"greatest memory", shown_bytes(summary.peak_memory)}};
    return "<section><h2>What it cost</h2><div class=\"tables\">" + phase_table(summary) + "<div class=\"tables\">" + count_table(summary) +
           table("Machine", {}, machine) + "</div></div></section>\n";
}

std::string report_repeat(const RunSummary& summary, const std::string& resolved_case)
{
    std::string text = "<section><h2>To run it again</h2><div class=\"card\">";
    if (!summary.command.empty()) text += "<p>Command: <code>" + escaped(summary.command) + "</code></p>";
    if (!summary.program.empty()) text += "<p>Program: " + escaped(summary.program) + "</p>";
    text += fmt::format("<p>Seed {}. The same program, case and seed give the same bits on any number of threads.</p>", summary.seed);
    if (!resolved_case.empty()) {
        text += "<details><summary>The case with every default filled in (case.resolved.toml)</summary><pre>" + escaped(resolved_case) +
                "</pre></details>";
    }
    return text + "</div></section>\n";
}

}  // namespace corpuscle
