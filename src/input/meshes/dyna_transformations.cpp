#include "input/meshes/dyna_transformations.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace corpuscle {

void DynaTransformations::begin(const std::string& options)
{
    if (!options.empty() && options != "_TITLE")
        cards_.lines().fail(fmt::format("*DEFINE_TRANSFORMATION{} is not read", options), "use *DEFINE_TRANSFORMATION");
    titled_ = cards_.blanks_count = !options.empty();
    id_ = 0;
    points_.clear();
}

void DynaTransformations::read()
{
    if (titled_) {
        titled_ = cards_.blanks_count = false;
        return;
    }
    const auto& card = cards_.fields(8, 10);
    const DeckLines& lines = cards_.lines();
    if (id_ == 0) {
        id_ = integer_field(lines, card[0], "the number of a transformation") + cards_.file().definition;
        if (id_ < 1 || contains(id_))
            lines.fail(fmt::format("transformation {} {}", id_, id_ < 1 ? "has no number from 1 on" : "is given twice"),
                       "give each transformation a number of its own");
        maps_[id_];
        return;
    }
    Values values{};
    for (std::size_t i = 1; i < std::min(card.size(), values.size() + 1); ++i)
        values[i - 1] = real_field(lines, card[i], "a number of a transformation");
    AffineMap& map = maps_.at(id_);
    map = step(in_capitals(card[0]), values).after(map);
}

const AffineMap& DynaTransformations::of(std::int64_t id) const
{
    const auto found = maps_.find(id);
    if (found == maps_.end())
        cards_.lines().fail(fmt::format("there is no transformation {} before this line", id), "give it with *DEFINE_TRANSFORMATION first");
    return found->second;
}

AffineMap DynaTransformations::step(const std::string& option, const Values& v)
{
    if (option == "TRANSL") return moved_by({v[0], v[1], v[2]});
    if (option == "ROTATE") return rotation(v);
    if (option == "MIRROR") {
        const Vector3d foot{v[0], v[1], v[2]};
        return mirrored_in(foot, direction(Vector3d{v[3], v[4], v[5]} - foot));
    }
    if (option == "SCALE") {
        const auto factor = [](double value) { return value == 0 ? 1.0 : value; };
        return stretched_by({factor(v[0]), factor(v[1]), factor(v[2])});
    }
    if (option == "POINT") {
        points_[v[0]] = {v[1], v[2], v[3]};
        return {};
    }
    cards_.lines().fail(fmt::format("'{}' in a transformation is not read", shown_field(option)),
                        "use TRANSL, ROTATE, SCALE, MIRROR and POINT, or write the mesh out in its place");
}

/// About an axis through a point by an angle [degrees], or, if only three numbers are given, through two points by the third. What comes
/// before has moved the points, too.
AffineMap DynaTransformations::rotation(const Values& v) const
{
    constexpr double degree = std::numbers::pi / 180;
    if (std::any_of(v.begin() + 3, v.end(), [](double value) { return value != 0; }))
        return turned_about({v[3], v[4], v[5]}, direction({v[0], v[1], v[2]}), v[6] * degree);
    if (v[2] == 0 || v[0] == 0 || v[1] == 0) return {};  // by no angle: points have numbers from 1 on
    const AffineMap& before = maps_.at(id_);
    const Vector3d from = before(point(v[0])), to = before(point(v[1]));
    return turned_about(from, direction(to - from), v[2] * degree);
}

const Vector3d& DynaTransformations::point(double id) const
{
    const auto found = points_.find(id);
    if (found == points_.end())
        cards_.lines().fail(fmt::format("there is no POINT {} in this transformation", id),
                            "give both points before ROTATE, or the axis, a point on it and the angle");
    return found->second;
}

Vector3d DynaTransformations::direction(const Vector3d& along) const
{
    if (!(norm(along) > 0)) cards_.lines().fail("a direction of a transformation has no length", "give two points that differ");
    return along;
}

}  // namespace corpuscle
