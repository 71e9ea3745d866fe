#pragma once

#include <string>
#include <vector>

#include "schema/parameter.hpp"

namespace corpuscle {

/// A parameter with its full name in a case: "charge.mass".
struct NamedParameter {
    std::string path;
    const Table* table = nullptr;
    const Parameter* parameter = nullptr;
};

/// Every parameter under a table, inner ones too, in the order of the rows.
[[nodiscard]] std::vector<NamedParameter> all_parameters(const Table& root);

/// What `key` is: by full name ("charge.mass"), or by its last word ("mass": all that are called so). Errors: InputError with the
/// nearest names.
[[nodiscard]] std::string explain(const Table& root, const std::string& key);

/// The reference page of all parameters, in Markdown.
[[nodiscard]] std::string reference_page(const Table& root);

}  // namespace corpuscle
