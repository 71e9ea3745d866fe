#include "structure/part_description.hpp"

namespace corpuscle {

namespace {

constexpr Directions every_direction{true, true, true};

}  // namespace

Hold clamp(std::vector<std::uint32_t> nodes)
{
    return {std::move(nodes), every_direction, every_direction};
}

Hold pin(std::vector<std::uint32_t> nodes)
{
    return {std::move(nodes), every_direction, {}};
}

Hold symmetry(std::vector<std::uint32_t> nodes, int axis)
{
    const Directions along{axis == 0, axis == 1, axis == 2};
    return {std::move(nodes), along, {!along.x, !along.y, !along.z}};
}

}  // namespace corpuscle
