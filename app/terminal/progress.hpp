#pragma once

#include <chrono>
#include <string>

#include "simulation/simulation.hpp"

namespace corpuscle {

/// A bar for people, lines for files, nothing for scripts.
enum class ProgressStyle { none, bar, lines };

/// Shows on standard error how far a run is: time, percent, step and what sets it, energy error, time left.
class ProgressDisplay {
public:
    explicit ProgressDisplay(ProgressStyle style) : style_(style) {}

    /// Called after every step; shows it if the last was long enough ago (bar: a tenth of a second; lines: a twentieth of the run).
    void show(const Progress& progress);
    /// Shows the last state and ends the line.
    void finish();

private:
    void draw(const Progress& progress);

    ProgressStyle style_;
    Progress last_;
    bool shown_last_ = true;
    int twentieths_ = -1;
    std::chrono::steady_clock::time_point drawn_at_{};
};

/// One line of progress, without the bar.
[[nodiscard]] std::string progress_text(const Progress& progress);

}  // namespace corpuscle
