#pragma once

#include <string>

#include "input/case/case_description.hpp"
#include "laws/load/time_curve.hpp"

namespace corpuscle {

/// The curve a case gives; its file, if it names one, is read. `unit` is the SI unit of its values.
/// Errors: InputError with the file's line for what is no table of rising times, at the case's place for a file that is not there.
[[nodiscard]] TimeCurve make_curve(const CurveInput& input, const std::string& unit, const CaseDescription& description);

}  // namespace corpuscle
