#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "laws/eos/equation_of_state.hpp"
#include "radial/symmetry.hpp"

namespace corpuscle {

/// Gas between two radii, in equal state: what a flow is laid out from. `edges` are its cells' ends, inner first.
struct RadialZone {
    std::vector<double> edges;  ///< [m]
    EquationOfState law;
    double density = 0;              ///< [kg/m3]
    double energy = 0;               ///< specific [J/kg]
    double velocity = 0;             ///< [m/s]
    double detonation_velocity = 0;  ///< of an explosive lit at radius 0, time 0 [m/s]; 0: gas from the start
};

/// Mass, radial momentum and energy [kg, kg m/s, J], of the whole or of one gas; for one unit of what lies around (see `area`).
struct RadialContents {
    double mass = 0;
    double momentum = 0;
    double kinetic_energy = 0;
    double internal_energy = 0;
    [[nodiscard]] double energy() const { return kinetic_energy + internal_energy; }
};

/// One-dimensional flow of gases of any law, planar, cylindrical or spherical, in cells that move with the gas, so that the face between
/// two gases stays sharp. Velocities live on the edges of cells, all else within; both ends keep the velocity they start with.
/// The scheme (compatible: Caramana, Burton, Shashkov, Whalen, J. Comput. Phys. 146 (1998) 227): forces of the pressures at half time, and
/// the work that the same forces do taken from the cells, so that mass and total energy are kept to round-off, and momentum in the plane;
/// shocks by the viscous pressure of Kurapatenko, switched off where the flow is smooth. Second order where it is smooth.
class RadialFlow {
public:
    /// Lays zones side by side, innermost first; each begins at the radius where the one before ends. Errors: InputError.
    RadialFlow(Symmetry symmetry, const std::vector<RadialZone>& zones);

    [[nodiscard]] Symmetry symmetry() const { return symmetry_; }
    [[nodiscard]] double time() const { return time_; }  ///< [s]
    [[nodiscard]] std::size_t cells() const { return mass_.size(); }
    [[nodiscard]] std::uint32_t gas(std::size_t cell) const { return gas_[cell]; }  ///< number of the zone it came from
    [[nodiscard]] const EquationOfState& law(std::size_t cell) const { return laws_[gas_[cell]]; }
    [[nodiscard]] const std::vector<double>& edges() const { return radius_; }         ///< [m]
    [[nodiscard]] const std::vector<double>& velocities() const { return velocity_; }  ///< of the edges [m/s]
    [[nodiscard]] const std::vector<double>& masses() const { return mass_; }  ///< of the cells, for one unit of what lies around [kg]
    [[nodiscard]] const std::vector<double>& densities() const { return density_; }   ///< [kg/m3]
    [[nodiscard]] const std::vector<double>& energies() const { return energy_; }     ///< specific, internal [J/kg]
    [[nodiscard]] const std::vector<double>& pressures() const { return pressure_; }  ///< [Pa]
    [[nodiscard]] double middle(std::size_t cell) const { return 0.5 * (radius_[cell] + radius_[cell + 1]); }  ///< [m]

    /// Edges beyond this one have not felt anything yet.
    [[nodiscard]] std::size_t disturbed() const { return disturbed_; }
    /// Whether some explosive still waits.
    [[nodiscard]] bool burning() const { return time_ < burnt_out_; }

    /// A step that is stable [s].
    [[nodiscard]] double stable_step() const;
    /// Moves on by a time [s], in one step.
    void step(double length);
    /// Moves on to a time [s] in stable steps; `watch` is called after each.
    template <class Watch>
    void run(double end, const Watch& watch)
    {
        while (time_ < end * (1 - 1e-14)) {
            step(next_step(end - time_));
            watch(*this);
        }
    }
    void run(double end)
    {
        run(end, [](const RadialFlow&) {});
    }

    /// What is there, of one gas or (-1) of all. The masses of edges are shared between the cells they part.
    [[nodiscard]] RadialContents contents(int gas = -1) const;

private:
    void lay(const RadialZone& zone, std::uint32_t gas);
    [[nodiscard]] double next_step(double remaining);
    [[nodiscard]] double burnt_share(std::size_t cell, double time) const;
    [[nodiscard]] double strain_rate(std::size_t cell) const;
    [[nodiscard]] double viscous_pressure(std::size_t cell) const;
    /// Moves edges and cells by the forces of `stress_` on the areas `area_`, from the state at the step's start.
    void move(double length);
    void find_states(double time);
    void find_sound();
    void find_disturbed();

    Symmetry symmetry_;
    std::vector<EquationOfState> laws_;
    double time_ = 0;
    double burnt_out_ = 0;  ///< when the last explosive has burnt [s]
    double last_step_ = 0;  ///< [s]
    std::size_t disturbed_ = 0;

    std::vector<double> radius_, velocity_, edge_mass_, area_;  ///< of the edges
    std::vector<std::uint32_t> gas_;                            ///< of the cells, as all below
    std::vector<double> mass_, density_, energy_, pressure_, sound_, stress_;
    std::vector<double> viscous_;  ///< viscous pressure of the present step [Pa]
    struct {
        std::vector<double> radius, velocity, energy, pressure;
    } start_;                                       ///< the state at the present step's start
    std::vector<double> burn_start_, burn_length_;  ///< when a cell's explosive begins to burn, and for how long [s]
};

}  // namespace corpuscle
