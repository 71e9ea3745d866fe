#pragma once

#include "euler/grid.hpp"
#include "input/case/case_description.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

struct EulerPlan;

/// Solves the plan's one ball of explosive in one dimension until its front nears the first thing it meets: a face of the grid that is no
/// plane of symmetry through it, a facet of the structure, or another fill. Its products have then burnt. Errors: InputError where the
/// start does not apply.
void plan_grid_start(EulerPlan& plan, const Structure& structure, const CaseDescription& description);

/// Lays the grid out from the plan's fills and, within its front, the blast: cells are means of points, then the masses of products and of
/// surrounding gas, the momentum and the energy within the cells that the blast has reached are made those of the radial flow, to
/// round-off.
void fill_from_blast(EulerGrid& grid, const EulerPlan& plan);

}  // namespace corpuscle
