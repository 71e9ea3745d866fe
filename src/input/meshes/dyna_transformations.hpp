#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "input/meshes/dyna_cards.hpp"

namespace corpuscle {

/// The transformations that a deck defines: SCALE, ROTATE (about a line, or through two POINTs), TRANSL, MIRROR, POINT, one after the
/// other. Source: LS-DYNA Keyword User's Manual, volume I, *DEFINE_TRANSFORMATION.
class DynaTransformations {
public:
    explicit DynaTransformations(DynaCards& cards) : cards_(cards) {}

    /// Begins *DEFINE_TRANSFORMATION, with its options; `read` takes each card that follows.
    void begin(const std::string& options);
    void read();

    [[nodiscard]] bool contains(std::int64_t id) const { return maps_.contains(id); }
    /// The whole transformation of that number; refuses, at the present line, one that is not there.
    [[nodiscard]] const AffineMap& of(std::int64_t id) const;

private:
    using Values = std::array<double, 7>;

    [[nodiscard]] AffineMap step(const std::string& option, const Values& values);
    [[nodiscard]] AffineMap rotation(const Values& values) const;
    [[nodiscard]] const Vector3d& point(double id) const;
    [[nodiscard]] Vector3d direction(const Vector3d& along) const;

    DynaCards& cards_;
    std::map<std::int64_t, AffineMap> maps_;
    std::int64_t id_ = 0;                ///< of the one that is read; 0 before its number has come
    bool titled_ = false;                ///< the next line is its title
    std::map<double, Vector3d> points_;  ///< of the one that is read
};

}  // namespace corpuscle
