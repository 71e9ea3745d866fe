#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "laws/blast/kingery_bulmash.hpp"
#include "mesh/shape.hpp"

// What a run is asked to record.

namespace corpuscle {

/// A value to draw beside a curve.
struct Reference {
    double value = 0;  ///< in the quantity's SI unit
    int component = 2;
    std::string label;
};

/// Follows a node of the structure.
struct Probe {
    std::string name;
    std::uint32_t node = 0;
    bool displacement = true;
    bool velocity = false;
    double every = 0;  ///< [s]
    std::optional<Reference> reference;
};

/// Pressure on the facets of a part: the net load of gas and loads on both sides, against the facets' normals, over their area.
struct PartGauge {
    std::uint32_t part = 0;
};

/// Pressure on a rigid face of the gas box, by what bounces off it.
struct FaceGauge {
    int face = 0;
};

/// State of the gas in a region.
struct RegionGauge {
    Shape shape;
    double volume = 0;  ///< of its part within the gas box [m3]
};

/// Pressure on a rigid face of the grid of gases.
struct GridFaceGauge {
    int face = 0;  ///< in the grid's axes
};

/// State of the gases on a grid in a region: its cells, each with the volume of its part within, the whole way round.
struct GridRegionGauge {
    std::vector<std::size_t> cells;
    std::vector<double> volumes;  ///< [m3]
};

struct Gauge {
    std::string name;
    std::variant<PartGauge, FaceGauge, RegionGauge, GridFaceGauge, GridRegionGauge> place;
    double every = 0;  ///< [s]
};

/// The one charge of a case as the curves of Kingery and Bulmash know it: what gauges are shown beside.
struct KnownBlast {
    double mass = 0;                 ///< of TNT, or its equivalent by energy [kg]
    Vector3d center;                 ///< [m]
    Burst burst = Burst::spherical;  ///< a hemisphere lies flat on a rigid face of the box
    double time = 0;                 ///< of detonation [s]
    double ambient = 0;              ///< pressure of the air around [Pa]
};

/// Files for ParaView and restarts.
struct OutputSettings {
    double fields_every = 0;     ///< [s], 0: none
    double history_every = 0;    ///< of the energies [s]
    double restart_every = 600;  ///< of wall clock [s]
    std::size_t particles_shown = 200'000;
    int averages = 48;  ///< cells along the longest side of the grid of averages; 0: no grid is shown
    bool compress = false;
};

}  // namespace corpuscle
