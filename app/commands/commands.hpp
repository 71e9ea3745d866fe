#pragma once

#include "app/options.hpp"
#include "input/case/case_description.hpp"

// One function a command; each returns the exit code and leaves errors to the caller.

namespace corpuscle {

int run_command(const Options& options);
int resume_command(const Options& options);
int report_command(const Options& options);
int check_command(const Options& options);
int radial_command(const Options& options);
int new_command(const Options& options);
int list_command(const Options& options);
int explain_command(const Options& options);
int bench_command(const Options& options);

/// Reads the case of the options with its settings, presets looked up.
[[nodiscard]] CaseDescription case_of(const Options& options);

}  // namespace corpuscle
