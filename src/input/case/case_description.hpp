#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/euler_input.hpp"
#include "input/case/gas_input.hpp"
#include "input/case/part_input.hpp"
#include "input/case/record_input.hpp"

namespace corpuscle {

/// A case as its file gives it, in SI, defaults filled in: plain values, each with the place it was read at.
struct CaseDescription {
    std::string title;
    double end_time = 0;  ///< [s]
    int ensemble = 1;     ///< runs that differ by their seed
    std::vector<ChargeInput> charges;
    std::optional<GasInput> gas;
    std::optional<EulerInput> euler;
    std::vector<FillInput> fills;
    std::vector<PartInput> parts;
    std::vector<LoadInput> loads;
    Vector3d gravity;  ///< [m/s2]
    std::vector<ProbeInput> probes;
    std::vector<GaugeInput> gauges;
    OutputInput output;
    Places places;
    std::filesystem::path folder;  ///< files named in the case lie beside it
    std::filesystem::path file;    ///< the case itself
};

/// The root of all tables.
template <>
const Table& table_of<CaseDescription>();

}  // namespace corpuscle
