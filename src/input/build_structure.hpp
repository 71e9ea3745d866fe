#pragma once

#include <string>
#include <vector>

#include "contact/curve_loads.hpp"
#include "input/case/case_description.hpp"
#include "mesh/quality.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// The mesh of a part, in its place. A ring whose inner radius is a disk's in the same case is made flush with it.
[[nodiscard]] Mesh make_mesh(const PartInput& part, const CaseDescription& description);

/// What is worth knowing of a part before it is run.
struct PartReport {
    std::string name, kind;
    std::size_t elements = 0, nodes = 0;
    double mass = 0;           ///< [kg], 0: a wall
    MeshQuality quality;       ///< of its mesh
    double step = 0;           ///< longest stable step of its elements, with the safety factor; infinite for rigid ones [s]
    double usual_step = 0;     ///< of the element in the middle of all [s]
    std::int64_t slowest = 0;  ///< number of the element that sets the step
    std::int64_t slender = 0, warped = 0, badly_shaped = 0;  ///< numbers of the worst elements

    /// One line for people.
    [[nodiscard]] std::string text() const;
};

/// A load of the case with its nodes found and its curve read; of ConWep neither is used.
struct PlannedLoad {
    LoadedNodes where;
    TimeCurve curve;
};

/// What comes out beside the structure when it is built.
struct StructureNotes {
    std::vector<std::string> warnings;  ///< remarks on doubtful meshes
    std::vector<PartReport> parts;
    std::vector<PlannedLoad> loads;  ///< one for each of the case
};

/// Builds all parts. Errors: InputError at the part's place.
[[nodiscard]] Structure build_structure(const CaseDescription& description, StructureNotes& notes);

}  // namespace corpuscle
