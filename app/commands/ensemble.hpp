#pragma once

#include <cstddef>

#include "app/options.hpp"
#include "input/case/case_description.hpp"
#include "simulation/run_folder.hpp"

namespace corpuscle {

/// Runs a case with as many seeds as it asks for into folders of their own, some at a time, then says what they say together.
/// Returns the exit code.
int run_ensemble(const Options& options, const CaseDescription& description, const RunFolder& folder);

/// Goes on with an interrupted ensemble: members that are done stay, those with a saved state go on from it.
int resume_ensemble(const Options& options, const CaseDescription& description, const RunFolder& folder);

/// How many members run at a time: one a thread, as a run on one thread loses nothing to waiting, but no more than memory holds.
[[nodiscard]] int members_at_once(int members, std::size_t memory_of_one);

}  // namespace corpuscle
