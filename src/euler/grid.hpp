#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "euler/axis.hpp"
#include "euler/walls.hpp"
#include "fields/field.hpp"
#include "laws/eos/equation_of_state.hpp"
#include "laws/eos/mie_grueneisen.hpp"
#include "math/box.hpp"
#include "math/vector3.hpp"

namespace corpuscle {

/// Most gases that one grid can hold, and most cells along a block's axis.
inline constexpr std::size_t most_euler_materials = 4, most_block_cells = 32;

/// A material with less than this share of a cell is a trace: it shows no pressure of its own [1].
inline constexpr double least_share = 1e-12;

/// What an edge of the grid does.
enum class EulerEdge {
    rigid,  ///< a wall without friction; also a plane of symmetry
    open,   ///< the state goes on unchanged beyond: what comes leaves
};

/// Where and when a charge of an explosive is lit.
struct EulerLighting {
    Vector3d point;   ///< [m]; (0, height, 0) in an axisymmetric grid, (0, 0, 0) in a spherical one
    double time = 0;  ///< [s]
    Box charge{};     ///< around it: what is nearer to another charge of the explosive is not lit from here; empty: there is no other [m]
};

/// What of a material waits to burn: it is then the products' law with less energy, so that it rests under the pressure around it.
struct EulerExplosive {
    double energy = 0;       ///< of detonation, specific [J/kg]
    double held_energy = 0;  ///< that the burning adds to what is in the grid, specific [J/kg]: `energy` less that of matter at rest
    double detonation_velocity = 0;  ///< [m/s]; 0: no explosive
    std::vector<EulerLighting> lightings;
    double burnt_out = 0;  ///< when the detonation has passed all that waited at the start; set by the fill [s]

    [[nodiscard]] bool burns() const { return detonation_velocity > 0; }
};

/// A gas of the grid.
struct EulerMaterial {
    std::string name;
    EquationOfState law;
    EulerExplosive explosive;
    double molar_mass = 0;  ///< 0: not known [kg/mol]
};

/// Mass of each material, momentum and energy [kg, kg m/s, J].
struct EulerAmount {
    std::array<double, most_euler_materials> mass{};
    Vector3d momentum;
    double energy = 0;

    EulerAmount& operator+=(const EulerAmount& other);
    [[nodiscard]] double whole_mass() const { return mass[0] + mass[1] + mass[2] + mass[3]; }
};

/// Faces of the grid are numbered x-, x+, y-, y+, z-, z+.
inline constexpr int euler_face_count = 6;
using EulerPassages = std::array<EulerAmount, euler_face_count>;

/// The numbers of all cells, per volume, x fastest.
struct EulerState {
    std::vector<std::vector<double>> mass;      ///< partial density of each material [kg/m3]
    std::array<std::vector<double>, 3> motion;  ///< momentum [kg/m2 s]
    std::vector<double> energy;                 ///< kinetic and internal [J/m3]
    std::vector<std::vector<double>> share;     ///< share of the volume of each material but the last [1]
    std::vector<std::vector<double>> unburnt;   ///< of `mass`, what waits to burn, of each material that burns (else empty) [kg/m3]
};

/// Share of the volume of any material, the last too.
[[nodiscard]] double share_of(const EulerState& state, std::size_t material, std::size_t cell);

/// Density of a material in its own part of a cell, from its mass in the cell's volume and its share of it; of a trace, so thin that it
/// is an ideal gas [kg/m3].
[[nodiscard]] inline double phase_density(const MieGrueneisen& law, double mass, double share)
{
    const double thin = 1e-3 * law.reference_density, own = share > least_share ? mass / share : thin;
    const double bounded = own < law.largest_density ? own : law.largest_density;
    return bounded > 0 ? bounded : thin;
}

/// A box of cells that are computed together.
struct EulerBlock {
    std::array<std::size_t, 3> begin{}, end{};
    bool quiet = false;           ///< all cells are in one state at rest, the state in which they were laid out
    bool active = false;          ///< computed: not quiet, or next to one that is not
    bool walled = false;          ///< walls are in it or in the cells that it sees; never quiet
    std::uint32_t materials = 0;  ///< bit m: material m is in a cell
    double signal = 0;            ///< largest sum over the axes of (|u| + c) area/volume, with the larger face, of a cell [1/s]
};

/// How the grid is computed.
struct EulerSettings {
    double cfl = 0.8;              ///< step over the time in which waves along all axes together cross a cell, below 1
    std::size_t block_cells = 16;  ///< about as many along each axis of a block, 4 to 32
    bool skip_quiet = true;        ///< leave blocks alone that nothing has reached
};

/// Several gases on a grid that stands still: geometry, state and settings. Its verbs are functions: see fill.hpp, burn.hpp, flow.hpp.
/// A grid of one cell along an axis is one that nothing moves along: dims (n, 1, 1) are a line, (n, m, 1) a plane.
struct EulerGrid {
    EulerSettings settings;
    EulerSpace space = EulerSpace::planar;
    std::array<EulerAxis, 3> axes;
    std::array<EulerEdge, euler_face_count> edges{};
    std::vector<EulerMaterial> materials;
    std::vector<MieGrueneisen> laws;  ///< of the materials, made for loops

    EulerWalls walls;      ///< that cut the grid
    EulerState now, next;  ///< `next` is room for the step to come; quiet blocks are alike in both
    std::vector<EulerBlock> blocks;
    std::array<std::size_t, 3> block_counts{};
    EulerPassages passages{};   ///< given to the edges since the start of the run
    double pressure_floor = 0;  ///< least pressure that a cell shows [Pa]
    double step_limit = 0;      ///< stable step found by the last survey [s]
    std::uint64_t worked = 0;   ///< cells computed since the start of the run, over all steps

    [[nodiscard]] std::size_t cells() const { return axes[0].cells() * axes[1].cells() * axes[2].cells(); }
    [[nodiscard]] std::size_t cell(std::size_t i, std::size_t j, std::size_t k) const
    {
        return i + axes[0].cells() * (j + axes[1].cells() * k);
    }
    [[nodiscard]] std::array<std::size_t, 3> place(std::size_t cell) const;  ///< numbers along the axes
    [[nodiscard]] Vector3d middle(std::size_t cell) const;                   ///< [m]
    [[nodiscard]] double volume(std::size_t cell) const;                     ///< of all that the cell stands for, the whole way round [m3]
    [[nodiscard]] double whole_volume(std::size_t cell) const;               ///< that it would have without walls [m3]
    /// Number of the lower face of the cell at a place, among all faces across an axis; the place may be one beyond the last cell.
    [[nodiscard]] std::size_t face_number(int axis, const std::array<std::size_t, 3>& place) const;
    /// All round what the axes leave out: 1, 2 pi, 4 pi.
    [[nodiscard]] double round() const;
};

/// Whether a lighting of an explosive is of the charge that a cell belongs to: the nearest one.
[[nodiscard]] bool lights(const EulerGrid& grid, const EulerExplosive& explosive, const EulerLighting& lit, std::size_t cell);

/// When the detonation of an explosive reaches a cell, straight from the nearest point in time where its charge is lit; inert axes do not
/// count [s].
[[nodiscard]] double burn_time(const EulerGrid& grid, const EulerExplosive& explosive, std::size_t cell);

/// A grid without content. `faces` of an inert axis: two, whose distance is its depth. Errors: InputError.
[[nodiscard]] EulerGrid make_grid(EulerSpace space, const std::array<std::vector<double>, 3>& faces,
                                  const std::array<EulerEdge, euler_face_count>& edges, std::vector<EulerMaterial> materials,
                                  const EulerSettings& settings = {});

/// What the grid holds, in a fixed order of addition. Explosive that waits counts as `explosive`, with all its energy of detonation.
struct EulerContents {
    EulerAmount gas;
    EulerAmount explosive;
    EulerContents& operator+=(const EulerContents& other);
};
[[nodiscard]] EulerContents contents(const EulerGrid& grid);

/// A cell in words.
struct EulerCell {
    double density = 0;                                ///< of the mixture [kg/m3]
    Vector3d velocity;                                 ///< [m/s]
    double pressure = 0;                               ///< [Pa]
    double energy = 0;                                 ///< internal, per volume [J/m3]
    double sound_speed = 0;                            ///< of the mixture [m/s]
    std::array<double, most_euler_materials> share{};  ///< of the volume
};
[[nodiscard]] EulerCell look(const EulerGrid& grid, std::size_t cell);

/// Cell averages for pictures: density, velocity, pressure, internal energy, shares of volume, burnt share.
[[nodiscard]] FieldSet cell_fields(const EulerGrid& grid);

/// All that a restart needs besides the case: the state, what left through the edges.
[[nodiscard]] FieldSet state(EulerGrid& grid);

}  // namespace corpuscle
