#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/conwep_load.hpp"
#include "contact/gas_structure.hpp"
#include "contact/grid_walls.hpp"
#include "euler/grid.hpp"
#include "gas/gas.hpp"
#include "model/ledger.hpp"
#include "model/records.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// All there is to simulate: the bodies, what they exchange, the books, and what is to be recorded.
/// Contacts refer to the bodies, so a model stays where it was made.
class Model {
public:
    Model(Gas gas_, Structure structure_);
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    std::string title;
    double start_time = 0;  ///< when the run begins: later than 0 where the blast's first part was solved beforehand [s]
    double end_time = 0;    ///< [s]

    Gas gas;
    EulerGrid euler;  ///< without cells, unless the case has gases on a grid
    Structure structure;
    GasStructureContact gas_structure;
    GridWalls grid_walls;
    std::vector<std::unique_ptr<Contact>> loads;  ///< contacts with the world outside: ConWep, ...
    Ledger ledger;

    std::vector<Probe> probes;
    std::vector<Gauge> gauges;
    std::optional<KnownBlast> known_blast;  ///< where the case has one charge, round and in air
    OutputSettings output;

    /// Where the gas sees facets in this step.
    [[nodiscard]] const FacetTree& walls() const { return gas_structure.tree(); }

    /// What all bodies hold after a step of this duration [s]; energy without what stepping in time has made or lost; of the structure's
    /// mass what it has lost by erosion.
    [[nodiscard]] Holding held(double duration) const;
};

/// Tells the gas, if any of it is to sleep, what of the structure can move, whether it moves from the start, and where solids are, which
/// gas presses on from one side.
void let_sleep_beside_structure(Model& model);

/// Adds the empirical blast load on a part to the model.
void add_conwep(Model& model, std::uint32_t part, const ConwepCharge& charge);

}  // namespace corpuscle
