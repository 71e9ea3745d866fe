#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "fields/field.hpp"
#include "fields/transfer.hpp"

namespace corpuscle {

/// Where two bodies, or a body and the world around it, exchange impulse and energy. Holds references to the bodies, which must
/// outlive it and stay where they are.
class Contact {
public:
    virtual ~Contact() = default;

    /// For logs and restarts.
    [[nodiscard]] virtual std::string name() const = 0;

    /// Lets the bodies meet in the step of the clock; returns what each gave the other, equal and opposite.
    virtual std::vector<Transfer> apply(const Clock& clock) = 0;

    /// Impulse that each facet of the structure has got from this contact since the start [N s].
    [[nodiscard]] virtual const std::vector<Vector3d>& facet_impulse() const = 0;

    /// Impulse that nodes of a part have got since the start beside that of its facets [N s].
    [[nodiscard]] virtual Vector3d impulse_beside_facets(std::uint32_t /*part*/) const { return {}; }

    /// What a restart needs.
    virtual FieldSet state() { return {}; }
};

}  // namespace corpuscle
