#pragma once

#include <vector>

#include "model/model.hpp"
#include "simulation/summary_verdict.hpp"

namespace corpuscle {

/// How finely particles, or the cells of a grid, resolve charges and the way to what they load, judged by a model that has not made a step;
/// the worst of all charges, nothing without any.
///
/// Cells: the widest over the charge's diameter, of what waits to burn, and over the stand-off. Particles:
/// "charge": spacing h0 = (m/rho)^(1/3) of the unburnt particles over the charge's diameter 2 r0, r0 from the first detonation point to the
/// furthest particle. "resolution": spacing where the load arrives over the stand-off R, from that point to the nearest facet or
/// gauged face of the box; there the products, spread over a ball, are h0 R/r0 apart, the air as ever; the wider of the two counts.
[[nodiscard]] std::vector<Verdict> judge_resolution(const Model& model);

}  // namespace corpuscle
