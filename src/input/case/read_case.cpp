#include "input/case/read_case.hpp"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "input/case/toml_source.hpp"

namespace corpuscle {

namespace {

/// LS-DYNA decks begin with a line *KEYWORD, after comments ($).
bool looks_like_deck(const std::string& text)
{
    std::stringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line[0] == '$' || line[0] == '\r') continue;
        return line[0] == '*';
    }
    return false;
}

/// A file beside the case, wherever the written case will lie.
std::string full_path(const std::string& file, const CaseDescription& description)
{
    return (description.folder / file).lexically_normal().string();
}

void complete_path(ShapeInput& shape, const CaseDescription& description)
{
    if (shape.surface) shape.surface->file = full_path(shape.surface->file, description);
}

void complete_path(std::optional<CurveInput>& curve, const CaseDescription& description)
{
    if (curve && curve->file) curve->file->file = full_path(curve->file->file, description);
}

/// Meshes and curves of a part.
void complete_paths(PartInput& part, const CaseDescription& description)
{
    if (part.mesh.file) part.mesh.file = full_path(*part.mesh.file, description);
    for (DriveInput& drive : part.drive)
        for (auto* curve : {&drive.displacement, &drive.velocity, &drive.acceleration}) complete_path(*curve, description);
}

}  // namespace

CaseDescription read_case(const std::filesystem::path& file, const std::vector<std::string>& settings)
{
    if (std::filesystem::is_directory(file))
        throw InputError(fmt::format("'{}' is a folder", file.string()), "expected a case file (.toml)");
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    if (stream && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
    if (stream.bad() || !std::filesystem::exists(file) || !stream.is_open())
        throw InputError(fmt::format("the case '{}' cannot be read", file.string()),
                         "check its name; `corpuscle new plate` writes one to start from");
    CaseDescription description = read_case_text(text.str(), file.string(), settings);
    description.folder = std::filesystem::absolute(file).parent_path();
    description.file = file;
    return description;
}

CaseDescription read_case_text(const std::string& text, const std::string& file, const std::vector<std::string>& settings)
{
    if (looks_like_deck(text))
        throw InputError("this is an LS-DYNA keyword deck, which this version does not read",
                         "expected a case in TOML; `corpuscle new plate` writes one to start from", {file, 1, 1});
    Value document = parse_toml(text, file);
    for (const std::string& setting : settings) apply_setting(document, setting);
    CaseDescription description;
    Problems problems;
    read_table(&description, table_of<CaseDescription>(), document, problems);
    problems.raise();
    return description;
}

std::string resolved_case(const CaseDescription& description)
{
    CaseDescription full = description;
    for (PartInput& part : full.parts) complete_paths(part, description);
    for (LoadInput& load : full.loads)
        for (auto* curve : {&load.pressure, &load.force}) complete_path(*curve, description);
    for (ChargeInput& charge : full.charges) complete_path(charge.shape, description);
    for (FillInput& fill : full.fills) complete_path(fill.shape, description);
    return toml_document(write_table(&full, table_of<CaseDescription>()));
}

}  // namespace corpuscle
