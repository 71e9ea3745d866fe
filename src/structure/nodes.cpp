#include "structure/nodes.hpp"

namespace corpuscle {

std::uint32_t Nodes::add(const std::vector<Vector3d>& places)
{
    const std::size_t first = size(), count = first + places.size();
    for (std::vector<Vector3d>* place : {&reference, &previous, &position}) place->insert(place->end(), places.begin(), places.end());
    for (std::vector<Vector3d>* values : {&velocity, &angular_velocity, &force, &moment, &impulse, &inverse_mass, &inverse_inertia})
        values->resize(count);
    if (!bodies.empty()) body.resize(count, -1);
    mass.resize(count);
    inertia.resize(count);
    return static_cast<std::uint32_t>(first);
}

}  // namespace corpuscle
