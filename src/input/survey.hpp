#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/build_euler.hpp"
#include "input/build_gas.hpp"
#include "input/build_structure.hpp"
#include "input/case/case_description.hpp"

namespace corpuscle {

/// A case worked out but for its particles: every check of meaning is behind it. What `check` shows, what `build` builds on.
struct CaseSurvey {
    Structure structure;
    std::optional<GasPlan> gas;
    std::optional<EulerPlan> euler;
    std::size_t memory = 0;  ///< bytes a run will need
    std::vector<PlannedLoad> loads;
    std::vector<PartReport> parts;  ///< what is worth knowing of each part
    std::vector<std::string> warnings;
};

/// Checks a case whose presets are resolved, and works it out. Errors: InputError or InputProblems.
[[nodiscard]] CaseSurvey survey_case(const CaseDescription& description);

/// Steps a run will take, about: the least stable step of the structure and the gases, theirs growing as the cloud does.
[[nodiscard]] double expected_steps(const CaseSurvey& survey, double end_time);

}  // namespace corpuscle
