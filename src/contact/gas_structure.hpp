#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "contact/flight.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// What gas has pressed on each facet along its normal since the start, from its upper side (that of its own normal) and its lower one. [N
/// s]
struct FacetPress {
    std::vector<double> upper, lower;
};

/// What gas has given each part since the start.
struct PartsGiven {
    std::vector<Vector3d> impulse;  ///< [N s]
    std::vector<double> work;       ///< [J]
};

/// Gas on structure: particles bounce elastically off moving facets, each with the facet's effective mass at the point it hits, so
/// every pair keeps its momentum and energy. Bounces follow each other in an order that does not depend on threads.
class GasStructureContact : public Contact {
public:
    /// Both bodies must outlive the contact; the structure's surface must be complete.
    GasStructureContact(Gas& gas, Structure& structure);

    [[nodiscard]] std::string name() const override { return "gas_structure"; }

    /// The facets as they move in this step; valid after `follow`.
    [[nodiscard]] const FacetTree& tree() const { return tree_; }

    /// Takes up the step's motion of the nodes: after the structure's accelerate, before gas collides and flies.
    void follow();

    /// Flies the gas's pending particles to the end of the step, bouncing off facets and faces of the domain; impulses go to the
    /// nodes. Returns momentum and energy that "gas" gave to "structure" [kg m/s, J].
    std::vector<Transfer> apply(const Clock& clock) override;

    /// Impulse each facet has got since the start, from both sides together [N s], and how many hits.
    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }
    [[nodiscard]] const std::vector<std::uint64_t>& facet_hits() const { return facet_hits_; }
    /// Sum of the squared impulses, by component, that particles have given to each facet; what a particle gives in one step counts as
    /// one. Hits come like rain (Poisson), so this is the variance of the impulse [N2 s2].
    [[nodiscard]] const std::vector<Vector3d>& facet_squares() const { return facet_squares_; }
    [[nodiscard]] const FacetPress& facet_press() const { return press_; }
    /// By part, as far as parts have facets.
    [[nodiscard]] const PartsGiven& given_to_parts() const { return given_; }
    /// Particles that were squeezed where no free place was left since this was made: 0 in a sound run.
    [[nodiscard]] std::uint64_t trapped() const { return trapped_; }

    FieldSet state() override;

private:
    void begin_flights();
    void meet(Flight& flight, const FlightPath& path, Transfer& given);
    void meet_facet(Flight& flight, const FlightPath& path, Transfer& given);
    [[nodiscard]] double closing_velocity(const Flight& flight) const;
    [[nodiscard]] double effective_inverse_mass(const Flight& flight) const;
    void bounce(Flight& flight, double closing, Transfer& given);

    Gas& gas_;
    Structure& structure_;
    FacetTree tree_;
    std::vector<Flight> flights_;
    std::vector<Vector3d> facet_impulse_;  ///< [N s]
    std::vector<Vector3d> facet_squares_;  ///< [N2 s2]
    std::vector<std::uint64_t> facet_hits_;
    FacetPress press_;
    PartsGiven given_;
    std::uint64_t trapped_ = 0;
};

}  // namespace corpuscle
