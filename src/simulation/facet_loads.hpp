#pragma once

#include <vector>

#include "base/clock.hpp"
#include "fields/field.hpp"
#include "model/model.hpp"

namespace corpuscle {

/// What gas and loads press on each element of the structure, from both sides, for pictures: the specific impulse since the start and the
/// mean pressure since the picture before. The upper side is that of the element's normal by the right hand over its corners, of solids the
/// outside. Over the present area of what the element shows.
class FacetLoads {
public:
    explicit FacetLoads(const Model& model);

    /// Cell arrays for a picture at `time` [s]; valid until the next.
    [[nodiscard]] FieldSet picture(double time);

    /// Memory of the last picture, for a restart.
    [[nodiscard]] FieldSet state();

private:
    /// By element, over all parts.
    struct Sides {
        std::vector<double> upper, lower;
    };

    [[nodiscard]] Sides impulses() const;

    const Model& model_;
    Sides before_;              ///< specific impulse at the last picture [Pa s]
    Sides impulse_, pressure_;  ///< of this one [Pa s], [Pa]
    std::vector<double> time_;  ///< of the last picture [s]
};

}  // namespace corpuscle
