#include "input/meshes/read_mesh.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "input/meshes/abaqus.hpp"
#include "input/meshes/deck_lines.hpp"
#include "input/meshes/dyna_mesh.hpp"
#include "input/meshes/gmsh.hpp"
#include "input/meshes/scanner.hpp"
#include "input/meshes/stl.hpp"
#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

/// Languages of decks, whose keywords begin with a star.
enum class DeckLanguage { none, abaqus, dyna };

/// The language that a keyword or comment belongs to, if it belongs to one only.
DeckLanguage language_of(const std::string& line)
{
    if (line.starts_with("**") || line.starts_with("*HEADING") || line.starts_with("*PART,") || line.starts_with("*NODE,") ||
        line.starts_with("*ELEMENT,"))
        return DeckLanguage::abaqus;
    if (line.starts_with("$") || line.starts_with("*KEYWORD") || line.starts_with("*ELEMENT_")) return DeckLanguage::dyna;
    return DeckLanguage::none;
}

/// Which language a file is in: by the first line that tells, else by its name. A deck's first line that is not blank is a comment or a
/// keyword.
DeckLanguage deck_language(Scanner scanner)
{
    bool first = true;
    while (!scanner.at_end()) {
        const std::string line = in_capitals(trimmed_field(scanner.line()));
        if (first && !line.starts_with('*') && !line.starts_with('$')) return DeckLanguage::none;
        first = false;
        if (const DeckLanguage language = language_of(line); language != DeckLanguage::none) return language;
    }
    const std::string name = in_capitals(scanner.file());
    if (name.ends_with(".INP")) return DeckLanguage::abaqus;
    return name.ends_with(".K") || name.ends_with(".KEY") || name.ends_with(".DYN") ? DeckLanguage::dyna : DeckLanguage::none;
}

Mesh read_any(Scanner scanner)
{
    if (scanner.rest().starts_with("$Comments")) scanner.skip_past_line("$EndComments");
    if (scanner.rest().starts_with("$MeshFormat")) return read_gmsh(std::move(scanner));
    if (scanner.rest().starts_with("$NOD"))
        scanner.fail("gmsh format 1 is not supported", "save as version 4.1 or 2.2 (in gmsh: gmsh -0 FILE -format msh41 -o NEW)");
    if (looks_like_stl(scanner) || scanner.file().ends_with(".stl") || scanner.file().ends_with(".STL"))
        return read_stl(std::move(scanner));
    switch (deck_language(scanner)) {
        case DeckLanguage::abaqus: return read_abaqus(std::move(scanner));
        case DeckLanguage::dyna: return read_dyna_mesh(std::move(scanner));
        case DeckLanguage::none: break;
    }
    scanner.fail("this is no mesh file that is known",
                 "give a gmsh file (.msh, version 2.2 or 4.1), an Abaqus input file (.inp), an LS-DYNA deck (.k) or a surface (.stl)");
}

}  // namespace

Mesh read_mesh(const std::string& file, double unit_in_metre)
{
    if (!(unit_in_metre > 0.0) || !std::isfinite(unit_in_metre))
        throw InputError(fmt::format("the unit of mesh '{}' is {:.6g} m", file, unit_in_metre), "give a unit of length such as \"mm\"");
    Mesh mesh = read_any(Scanner::open(file));
    if (unit_in_metre != 1.0) scale(mesh, unit_in_metre);
    return mesh;
}

}  // namespace corpuscle
