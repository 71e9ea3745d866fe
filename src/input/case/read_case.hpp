#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case_description.hpp"

namespace corpuscle {

/// Reads a case file; `settings` ("charge.0.mass=20 kg") change it first. Presets stay names (see input/presets.hpp).
/// Errors: InputError or InputProblems, each with its place, what was expected and the nearest known name.
[[nodiscard]] CaseDescription read_case(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

/// As read_case, from text; `file` names it in messages.
[[nodiscard]] CaseDescription read_case_text(const std::string& text, const std::string& file,
                                             const std::vector<std::string>& settings = {});

/// The case as a TOML document with every default filled in, units and full paths written out: reading it, from
/// any folder, gives the same case.
[[nodiscard]] std::string resolved_case(const CaseDescription& description);

}  // namespace corpuscle
