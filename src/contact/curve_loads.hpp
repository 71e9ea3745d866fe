#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "laws/load/time_curve.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// Weight: every mass of the structure falls with the same acceleration. Gas is not heavy.
class GravityLoad final : public Contact {
public:
    /// Keeps a reference to the structure; `acceleration` in m/s2.
    GravityLoad(Structure& structure, const Vector3d& acceleration);

    [[nodiscard]] std::string name() const override { return "gravity"; }
    /// Adds mass times acceleration times the step to each node and body. Returns "gravity" -> "structure".
    std::vector<Transfer> apply(const Clock& clock) override;
    /// None: it pulls on masses, not on faces.
    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }

private:
    Structure& structure_;
    Vector3d acceleration_;
    std::vector<Vector3d> facet_impulse_;
};

/// Nodes of a part that a load acts on, and what it is called.
struct LoadedNodes {
    std::uint32_t part = 0;
    std::vector<std::uint32_t> nodes;  ///< of the structure, ascending
    std::string name;                  ///< for logs
};

/// A pressure over time on facets: on solids from outside, on shells against their normals (positive on the face that the normal looks out
/// of).
class PressureLoad final : public Contact {
public:
    /// Acts on those facets of the part all of whose nodes are given; keeps a reference to the structure. Throws InputError if there are
    /// none.
    PressureLoad(Structure& structure, const LoadedNodes& where, TimeCurve pressure);

    [[nodiscard]] std::string name() const override { return name_; }
    /// Adds the exact integral of the pressure over the step times each facet's present area, a third to each corner.
    std::vector<Transfer> apply(const Clock& clock) override;
    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }
    [[nodiscard]] FieldSet state() override;
    [[nodiscard]] const std::vector<std::uint32_t>& facets() const { return facets_; }

private:
    Structure& structure_;
    std::string name_;
    TimeCurve pressure_;
    std::vector<std::uint32_t> facets_;
    std::vector<Vector3d> facet_impulse_;  ///< so far, on every facet of the structure [N s]
};

/// A force over time in one direction, in equal parts on nodes.
class ForceLoad final : public Contact {
public:
    /// `direction` need not have unit length. Throws InputError if it has none, or if there are no nodes.
    ForceLoad(Structure& structure, LoadedNodes where, const Vector3d& direction, TimeCurve force);

    [[nodiscard]] std::string name() const override { return where_.name; }
    /// Adds the exact integral of the force over the step.
    std::vector<Transfer> apply(const Clock& clock) override;
    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }
    [[nodiscard]] Vector3d impulse_beside_facets(std::uint32_t part) const override;
    [[nodiscard]] FieldSet state() override;

private:
    Structure& structure_;
    LoadedNodes where_;
    Vector3d direction_;
    TimeCurve force_;
    std::vector<Vector3d> given_{Vector3d{}};  ///< so far, on all nodes together [N s]
    std::vector<Vector3d> facet_impulse_;      ///< none: it acts on nodes
};

}  // namespace corpuscle
