#include "app/terminal/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace corpuscle {

namespace {

double fraction_of(const Progress& progress)
{
    return progress.end_time > 0 ? std::clamp(progress.time / progress.end_time, 0.0, 1.0) : 1.0;
}

std::string clock_text(double seconds)
{
    const auto whole = std::lround(seconds);
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string bar_text(double fraction)
{
    constexpr int width = 24;
    const int full = static_cast<int>(fraction * width);
    return "[" + std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(width - full), '.') + "]";
}

}  // namespace

std::string progress_text(const Progress& progress)
{
    const double fraction = fraction_of(progress);
    const std::string left = fraction > 0.001 ? clock_text(progress.wall_seconds * (1 - fraction) / fraction) : "?";
    return fmt::format("{:3.0f} %  t {:.4g} of {:.4g} ms  step {} of {:.3g} us ({})  energy error {:.1e}  left {}", 100 * fraction,
                       1e3 * progress.time, 1e3 * progress.end_time, progress.step, 1e6 * progress.duration, progress.step_set_by,
                       progress.energy_error, left);
}

void ProgressDisplay::show(const Progress& progress)
{
    last_ = progress;
    shown_last_ = false;
    if (style_ == ProgressStyle::bar) {
        const auto now = std::chrono::steady_clock::now();
        if (now - drawn_at_ < std::chrono::milliseconds(100)) return;
        drawn_at_ = now;
        draw(progress);
    } else if (style_ == ProgressStyle::lines) {
        const int twentieths = static_cast<int>(20 * fraction_of(progress));
        if (twentieths == twentieths_) return;
        twentieths_ = twentieths;
        draw(progress);
    }
}

void ProgressDisplay::finish()
{
    if (style_ == ProgressStyle::none) return;
    if (!shown_last_) draw(last_);
    if (style_ == ProgressStyle::bar) fmt::print(stderr, "\n");
}

void ProgressDisplay::draw(const Progress& progress)
{
    if (style_ == ProgressStyle::bar)
        fmt::print(stderr, "\r{} {}\x1b[K", bar_text(fraction_of(progress)), progress_text(progress));
    else
        fmt::print(stderr, "{}\n", progress_text(progress));
    std::fflush(stderr);
    shown_last_ = true;
}

}  // namespace corpuscle
