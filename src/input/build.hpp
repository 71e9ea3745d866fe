#pragma once

#include <memory>

#include "input/survey.hpp"
#include "model/model.hpp"

namespace corpuscle {

/// Makes the model of a surveyed case: fills the gas, joins bodies, loads, probes and gauges. Remarks are added to the survey's
/// warnings. Errors: InputError at the place of what is wrong.
[[nodiscard]] std::unique_ptr<Model> build(const CaseDescription& description, CaseSurvey& survey);

/// As above, from a case whose presets are resolved.
[[nodiscard]] std::unique_ptr<Model> build(const CaseDescription& description);

}  // namespace corpuscle
