#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "laws/blast/blast_load.hpp"
#include "math/vector3.hpp"
#include "mesh/facet_tree.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// What faces get that do not see the charge: turned away from it, or with a facet between.
enum class Shadow {
    nothing,
    incident,  ///< the incident wave, as at their distance
};

/// A charge of TNT as the curves of Kingery and Bulmash know it.
struct ConwepCharge {
    double mass = 0;                 ///< of TNT, or its equivalent [kg]
    Vector3d center;                 ///< [m]
    Burst burst = Burst::spherical;  ///< a hemisphere stands on a ground that reflects; only the distance to its centre counts
    double time = 0;                 ///< of detonation [s]
    Shadow shadow = Shadow::nothing;
};

/// The empirical blast load on one part, in place of gas: each facet gets the pulse of its distance and angle on the face that sees the
/// charge, and nothing on the other. A facet whose centroid a facet of any part hides from the charge, and a solid's that looks away, is in
/// the shadow. Distance, angle, arrival and shadow are those of the structure as meshed (it has hardly moved while the pulse lasts); the
/// push follows the facet's present area and normal. Positive phase only.
class ConwepLoad final : public Contact {
public:
    /// Works out the pulse of every facet of structure.parts[part]; keeps a reference to the structure.
    /// Throws InputError if the part shows no facets, or one of them is nearer or farther than the curves reach.
    ConwepLoad(Structure& structure, std::uint32_t part, const ConwepCharge& charge);

    [[nodiscard]] std::string name() const override { return "conwep on " + part_name_; }

    /// Adds to nodes.impulse the exact integral of each facet's pressure over the step, a third to each corner.
    /// Returns "conwep" -> "structure": momentum, and the work done on the nodes.
    std::vector<Transfer> apply(const Clock& clock) override;

    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }

    /// Impulse that each facet has received.
    [[nodiscard]] FieldSet state() override;

    /// For pictures and histories, on the loaded facets: specific impulse so far, mean pressure over the last step, peak pressure, arrival.
    [[nodiscard]] FieldSet facet_fields();

    /// The loaded facets, as indices of structure.surface.facets.
    [[nodiscard]] const std::vector<std::uint32_t>& facets() const { return facets_; }

private:
    Structure& structure_;
    std::string part_name_;
    double detonation_time_;                ///< [s]
    std::vector<std::uint32_t> facets_;     ///< indices of the structure's facets
    std::vector<BlastLoad> loads_;          ///< of each facet
    std::vector<double> side_;              ///< +1 where the facet's normal points away from the charge, -1 where towards it
    std::vector<double> specific_impulse_;  ///< so far [Pa s]
    std::vector<double> pressure_;          ///< mean over the last step [Pa]
    std::vector<Vector3d> push_;            ///< of the step, on each loaded facet [N s]
    std::vector<Vector3d> facet_impulse_;   ///< so far, on every facet of the structure [N s]

    void add_facet(std::uint32_t facet, const ConwepCharge& charge, const FacetTree& tree);
    void find_pushes(const Clock& clock);
};

}  // namespace corpuscle
