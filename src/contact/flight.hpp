#pragma once

#include <cstdint>

#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// A particle on its way through a step among facets: first along its displacement by collisions, at the step's start, then
/// along its velocity. Everything between its two float positions is in double.
struct Flight {
    enum class State : std::uint8_t {
        moving,    ///< on a leg
        settling,  ///< to be put on the facet it has met, for the rest of the leg's time
        arrived    ///< at the end of the step, or gone
    };

    std::uint32_t particle = 0;
    State state = State::moving;
    bool displaced = false;   ///< on the displacement, the facets frozen at the step's start
    bool trapped = false;     ///< arrived without a place that is proved free
    float start = 0;          ///< fraction of the step at which the flight proper begins
    double fraction = 0;      ///< of the step, where the leg begins
    Vector3d displacement;    ///< what is left of it [m]
    Vector3d place;           ///< where the leg begins: never on or behind a facet [m]
    Vector3d goal;            ///< where it ends if nothing is met; a float position [m]
    std::int64_t facet = -1;  ///< just left
    struct {
        std::array<double, 3> weight{};
        Vector3d normal;  ///< towards the particle's side
    } left;               ///< where on it, as it was met
    FacetTree::Hit hit;   ///< facet met, if `face` is -1
    int face = -1;        ///< face of the domain met
    double met_at = 1;    ///< fraction of the leg
    int meetings = 0;
    Vector3d given;  ///< impulse to facets in this step [N s]
};

/// The geometry of flights: knows facets and the domain, but neither impulses nor masses. Every stored position is a float that
/// was tested after it was rounded, so a particle ends each step on the side of every facet on which it began.
class FlightPath {
public:
    FlightPath(const FacetTree& tree, const Domain& domain, double duration);

    /// A pending particle at the start of its way.
    [[nodiscard]] static Flight begin(const Pending& pending, const Particle& particle);

    /// Goes on until a facet or face is met (see `hit` and `face`) or the flight has arrived, which moves the particle.
    void advance(Flight& flight, Particle& particle) const;

    /// Turns the rest of the way at the facet met, as the particle's velocity has been turned.
    void leave_facet(Flight& flight) const;

    /// Turns the rest of the way at the rigid face met.
    void leave_face(Flight& flight) const;

    /// Has the particle carried by the facet met to the end of the leg.
    void settle_on_facet(Flight& flight) const;

private:
    [[nodiscard]] double end_of_leg(const Flight& flight) const { return flight.displaced ? 0.0 : 1.0; }
    [[nodiscard]] Vector3d goal_of(const Flight& flight, const Particle& particle) const;
    [[nodiscard]] Vector3d rounded(const Vector3d& point) const;
    [[nodiscard]] bool parts_from_facet(const Flight& flight) const;
    void keep_inside_unless_outbound(const Vector3d& place, Vector3d& goal) const;
    void step_back(Flight& flight) const;
    void arrive(Flight& flight, Particle& particle, const Vector3d& at) const;
    void settle(Flight& flight, Particle& particle) const;
    [[nodiscard]] bool is_free(const Flight& flight, const Vector3d& place, const Vector3d& corner, const Vector3d& normal) const;

    const FacetTree& tree_;
    const Domain& domain_;
    Box inside_;       ///< float positions nearest to the domain's faces, within it [m]
    double duration_;  ///< of the step [s]
    double push_ = 0;  ///< from a facet a particle is put on: some float steps at the domain's far corner [m]
};

}  // namespace corpuscle
