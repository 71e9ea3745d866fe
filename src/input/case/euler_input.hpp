#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "euler/grid.hpp"
#include "input/case/gas_input.hpp"
#include "input/case/preset_values.hpp"
#include "schema/preset.hpp"

// The gases on a grid as a case gives them; charges, fills and gauges are those of the gas of particles.

namespace corpuscle {

struct EulerInput {
    EulerSpace symmetry = EulerSpace::planar;
    std::vector<std::array<double, 2>> box;       ///< a range for each axis that the symmetry leaves [m]
    std::optional<double> cell_size;              ///< [m]
    std::vector<std::uint64_t> cells;             ///< along each of these axes
    std::vector<std::array<double, 2>> fine_box;  ///< where cells are of cell_size; beyond it they grow [m]
    std::optional<double> edge_cell_size;         ///< that they grow towards at the box's faces [m]
    EdgesInput edges;
    std::optional<Preset<GasValues>> fill;
    StartRule start = StartRule::detonation;
    double cfl = EulerSettings{}.cfl;
    bool sleep = EulerSettings{}.skip_quiet;
    Places places;
};

template <>
const std::vector<std::pair<std::string, EulerSpace>>& words_of<EulerSpace>();
template <>
const Table& table_of<EulerInput>();

}  // namespace corpuscle
