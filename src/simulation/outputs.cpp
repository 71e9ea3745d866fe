#include "simulation/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "output/vtk/view_script.hpp"

namespace corpuscle {

namespace {

constexpr std::chrono::seconds look_every{1};
constexpr double end_tolerance = 1e-12;  ///< of the end time, for its rounding

std::vector<HistoryColumn> all_columns(const OutputPlan& plan)
{
    std::vector<HistoryColumn> columns;
    for (const HistorySource& source : plan.history) columns.insert(columns.end(), source.columns.begin(), source.columns.end());
    return columns;
}

History open_history(const RunFolder& folder, const OutputPlan& plan, std::optional<double> resumed)
{
    if (resumed) return History::resume(folder.history(), all_columns(plan), *resumed);
    return {folder.history(), all_columns(plan)};
}

}  // namespace

Outputs::Outputs(RunFolder folder, OutputPlan plan) : Outputs(std::move(folder), std::move(plan), std::optional<double>()) {}

Outputs::Outputs(RunFolder folder, OutputPlan plan, double time) : Outputs(std::move(folder), std::move(plan), std::optional<double>(time))
{
}

Outputs::Outputs(RunFolder folder, OutputPlan plan, std::optional<double> resumed)
    : folder_(std::move(folder)),
      plan_(std::move(plan)),
      log_(folder_.log()),
      history_(open_history(folder_, plan_, resumed)),
      restart_(folder_.restart()),
      saved_at_(WallClock::now()),
      looked_at_(WallClock::now())
{
    for (const HistorySource& source : plan_.history) {
        samplings_.emplace_back(source.every);
        if (resumed) samplings_.back().resume(*resumed);
    }
    std::filesystem::create_directories(folder_.fields());
    for (const FieldSource& source : plan_.fields) {
        families_.push_back({VtkSeries(folder_.fields(), source.family), Interval(source.every)});
        if (!resumed) continue;
        families_.back().series.resume(*resumed);
        families_.back().interval.resume(*resumed);
    }
    if (!families_.empty()) write_view_script(folder_.fields());
    if (resumed) sampled_ = *resumed;
}

double Outputs::next_due() const
{
    double next = std::numeric_limits<double>::infinity();
    for (const Interval& sampling : samplings_) next = std::min(next, sampling.next());
    for (const Family& family : families_) next = std::min(next, family.interval.next());
    return next;
}

void Outputs::write_due(const Clock& clock)
{
    const double time = clock.end();
    const bool last = time >= plan_.end_time * (1 - end_tolerance);
    std::vector<bool> due;
    for (Interval& sampling : samplings_) due.push_back(sampling.take(time) || last);
    sample(time, due);
    for (std::size_t i = 0; i < families_.size(); ++i) {
        if (families_[i].interval.take(time) || last) families_[i].series.add(time, plan_.fields[i].write);
    }
}

/// One line of the history: the sources that are due, empty cells for the others.
void Outputs::sample(double time, const std::vector<bool>& due)
{
    if (std::find(due.begin(), due.end(), true) == due.end()) return;
    std::vector<double> values(history_.columns().size(), std::numeric_limits<double>::quiet_NaN());
    std::span<double> rest(values);
    for (std::size_t i = 0; i < plan_.history.size(); ++i) {
        const HistorySource& source = plan_.history[i];
        if (due[i]) source.sample(rest.first(source.columns.size()));
        rest = rest.subspan(source.columns.size());
    }
    history_.add(time, values);
    sampled_ = time;
}

void Outputs::save()
{
    if (!plan_.state) return;
    const std::filesystem::path file = restart_.save(plan_.state());
    saved_at_ = WallClock::now();
    log_.line(fmt::format("state saved in {}", file.filename().string()));
}

void Outputs::save_due()
{
    look_for_requests();
    const bool asked = request_ == FolderRequest::save;
    if (asked) request_ = FolderRequest::none;
    const std::chrono::duration<double> since = WallClock::now() - saved_at_;
    if (asked || since.count() >= plan_.restart_every) save();
}

void Outputs::finish(const Clock& clock)
{
    const double time = clock.time();
    if (sampled_ < time) sample(time, std::vector<bool>(plan_.history.size(), true));
    for (std::size_t i = 0; i < families_.size(); ++i) {
        VtkSeries& series = families_[i].series;
        if (series.entries().empty() || series.entries().back().time < time) series.add(time, plan_.fields[i].write);
    }
    save();
}

bool Outputs::stop_requested()
{
    look_for_requests();
    return request_ == FolderRequest::stop;
}

void Outputs::look_for_requests()
{
    const auto now = WallClock::now();
    if (request_ != FolderRequest::none || now - looked_at_ < look_every) return;
    looked_at_ = now;
    request_ = folder_.take_request();
}

}  // namespace corpuscle
