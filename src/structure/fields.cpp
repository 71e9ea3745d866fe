#include "structure/fields.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "structure/energy.hpp"

namespace corpuscle {

namespace {

/// The element of that number over all parts: value(elements, index in the part).
template <class Value>
auto at_element(const Structure& structure, std::size_t number, const Value& value)
{
    const auto after = std::upper_bound(structure.parts.begin(), structure.parts.end(), number,
                                        [](std::size_t n, const Part& part) { return n < part.first_element; });
    const Part& part = *(after - 1);
    return std::visit([&](const auto& elements) { return value(elements, number - part.first_element); }, part.elements);
}

/// A shown number of each element.
template <class Value>
Field element_field(const Structure& structure, const char* name, const char* unit, const char* meaning, Value value)
{
    return derived_field<float>(name, unit, meaning, structure.element_count(),
                                [&structure, value](std::size_t i) { return static_cast<float>(at_element(structure, i, value)); });
}

template <class Member>
Field value_field(const Structure& structure, const char* name, const char* unit, const char* meaning, Member member)
{
    return element_field(structure, name, unit, meaning,
                         [member](const auto& elements, std::size_t e) { return elements.values(e).*member; });
}

template <class Member>
Field energy_field(const Structure& structure, const char* name, const char* meaning, Member member)
{
    return element_field(structure, name, "J", meaning,
                         [member](const auto& elements, std::size_t e) { return elements.energy(e).*member; });
}

/// A vector of each node, shown in single precision.
template <class Value>
Field node_field(const Structure& structure, const char* name, const char* unit, const char* meaning, Value value)
{
    return derived_field<Vector3f>(name, unit, meaning, structure.nodes.size(), [value](std::size_t i) { return Vector3f(value(i)); });
}

/// The loads of all corners as six numbers each: kept, as half of the next step's work is theirs.
Field corner_field(Structure& structure)
{
    std::vector<CornerLoad>& loads = structure.corner_loads;
    Field field{
        "corner_loads", "N, N m", "force and moment of each element on each of its corners", Scalar::float64, 3, 2 * loads.size(), {}, {}};
    field.gather = [&loads](void* out) {
        Vector3d* to = static_cast<Vector3d*>(out);
        for (const CornerLoad& load : loads) {
            *to++ = load.force;
            *to++ = load.moment;
        }
    };
    field.restore = [&loads](const void* in, std::size_t count) {
        if (count != 2 * loads.size())
            throw InputError("the saved state has another number of elements", "resume with the case it was saved from");
        const Vector3d* from = static_cast<const Vector3d*>(in);
        for (CornerLoad& load : loads) {
            load.force = *from++;
            load.moment = *from++;
        }
    };
    return field;
}

/// As `stored_field`, but refuses another number of nodes than the model has.
Field node_state(const char* name, const char* unit, const char* meaning, std::vector<Vector3d>& values)
{
    Field field = stored_field(name, unit, meaning, values);
    field.restore = [&values, take = field.restore](const void* in, std::size_t count) {
        if (count != values.size())
            throw InputError("the saved state has another number of nodes", "resume with the case it was saved from");
        take(in, count);
    };
    return field;
}

/// As `node_state`, of one number a node.
Field node_state(const char* name, const char* unit, const char* meaning, std::vector<double>& values)
{
    Field field = stored_field(name, unit, meaning, values);
    field.restore = [&values, take = field.restore](const void* in, std::size_t count) {
        if (count != values.size())
            throw InputError("the saved state has another number of nodes", "resume with the case it was saved from");
        take(in, count);
    };
    return field;
}

Field scalar_state(const char* name, const char* unit, const char* meaning, double& value)
{
    Field field{name, unit, meaning, Scalar::float64, 1, 1, {}, {}};
    field.gather = [&value](void* out) { *static_cast<double*>(out) = value; };
    field.restore = [&value](const void* in, std::size_t) { value = *static_cast<const double*>(in); };
    return field;
}

/// How the rigid bodies stand and move, eight vectors each.
Field body_field(std::vector<RigidBody>& bodies)
{
    constexpr std::size_t each = 8;
    const auto vectors = [](RigidBody& b) {
        return std::array<Vector3d*, each>{&b.center, &b.velocity, &b.spin_momentum, &b.impulse, &b.twist, &b.axis_x, &b.axis_y, &b.axis_z};
    };
    Field field{"rigid_bodies",
                "1",
                "center, velocity, angular momentum, what waits, and axes of each body",
                Scalar::float64,
                3,
                each * bodies.size(),
                {},
                {}};
    field.gather = [&bodies, vectors](void* out) {
        Vector3d* to = static_cast<Vector3d*>(out);
        for (RigidBody& body : bodies)
            for (const Vector3d* v : vectors(body)) *to++ = *v;
    };
    field.restore = [&bodies, vectors](const void* in, std::size_t count) {
        if (count != each * bodies.size())
            throw InputError("the saved state has another number of rigid bodies", "resume with the case it was saved from");
        const Vector3d* from = static_cast<const Vector3d*>(in);
        for (RigidBody& body : bodies)
            for (Vector3d* v : vectors(body)) *v = *from++;
    };
    return field;
}

}  // namespace

FieldSet node_fields(Structure& structure)
{
    const Nodes& n = structure.nodes;
    return {"structure nodes",
            {node_field(structure, "displacement", "m", "way from where the node was meshed",
                        [&n](std::size_t i) { return n.path().end[i] - n.reference[i]; }),
             node_field(structure, "velocity", "m/s", "velocity, with impulses just received",
                        [&n](std::size_t i) { return n.contact_velocity(static_cast<std::uint32_t>(i)); }),
             node_field(structure, "angular_velocity", "rad/s", "angular velocity", [&n](std::size_t i) { return n.angular_velocity[i]; }),
             node_field(structure, "force", "N", "force of the elements on the node", [&n](std::size_t i) { return n.force[i]; })}};
}

FieldSet element_fields(Structure& structure)
{
    using V = ElementValues;
    const Structure& s = structure;
    FieldSet set{"structure elements",
                 {value_field(s, "von_mises", "Pa", "largest equivalent stress of the element's points", &V::von_mises),
                  value_field(s, "von_mises_lower", "Pa", "equivalent stress of the lowest point", &V::von_mises_lower),
                  value_field(s, "von_mises_middle", "Pa", "equivalent stress of the middle point", &V::von_mises_middle),
                  value_field(s, "von_mises_upper", "Pa", "equivalent stress of the uppermost point", &V::von_mises_upper),
                  value_field(s, "plastic_strain", "1", "largest equivalent plastic strain of the element's points", &V::plastic_strain),
                  value_field(s, "thickness", "m", "present thickness of shells", &V::thickness),
                  value_field(s, "pressure", "Pa", "pressure, the mean of the element's points", &V::pressure),
                  value_field(s, "damage", "1", "damage of the element, gone at 1", &V::damage),
                  value_field(s, "heat", "K", "largest rise of temperature by plastic work", &V::heat),
                  energy_field(s, "internal_energy", "strain energy and plastic work of the element", &ElementEnergy::internal),
                  energy_field(s, "plastic_work", "plastic work of the element", &ElementEnergy::plastic),
                  energy_field(s, "hourglass_energy", "energy of hourglass control of the element", &ElementEnergy::hourglass)}};
    constexpr std::uint8_t hidden_cell = 32;  // as VTK marks cells that are not drawn
    set.fields.push_back(derived_field<std::uint8_t>(
        "vtkGhostType", "1", "32 where the element has eroded: ParaView hides it", s.element_count(), [&s](std::size_t i) {
            const auto left = [](const auto& elements, std::size_t e) { return elements.is_left(e); };
            return at_element(s, i, left) ? std::uint8_t{0} : hidden_cell;
        }));
    set.fields.push_back(derived_field<std::int32_t>("part", "1", "number of the part, from 0", s.element_count(), [&s](std::size_t i) {
        const auto after =
            std::upper_bound(s.parts.begin(), s.parts.end(), i, [](std::size_t n, const Part& part) { return n < part.first_element; });
        return static_cast<std::int32_t>(after - s.parts.begin() - 1);
    }));
    return set;
}

FieldSet state(Structure& structure)
{
    Nodes& n = structure.nodes;
    FieldSet set{"structure",
                 {node_state("previous", "m", "nodes at the start of the step", n.previous),
                  stored_field("path_start", "m", "nodes at the start of the gas's step, if that is another", n.path_start),
                  stored_field("path_end", "m", "nodes at its end, if that is another", n.path_end),
                  node_state("position", "m", "nodes at its end", n.position),
                  node_state("velocity", "m/s", "velocity", n.velocity),
                  node_state("angular_velocity", "rad/s", "angular velocity", n.angular_velocity),
                  node_state("force", "N", "internal forces", n.force),
                  node_state("moment", "N m", "internal moments", n.moment),
                  node_state("impulse", "N s", "impulses that wait", n.impulse),
                  corner_field(structure),
                  node_state("mass", "kg", "masses of nodes, less what has eroded", n.mass),
                  node_state("inertia", "kg m2", "rotary inertia of nodes, less what has eroded", n.inertia),
                  node_state("inverse_mass", "1/kg", "per direction, 0 where held", n.inverse_mass),
                  node_state("inverse_inertia", "1/(kg m2)", "per direction, 0 where held", n.inverse_inertia),
                  body_field(n.bodies),
                  stored_field("hidden", "1", "facets that are not there", structure.surface.hidden),
                  stored_field("turned", "1", "facets whose solid lies on their other side", structure.surface.turned),
                  scalar_state("eroded_elements", "1", "elements eroded", structure.eroded.elements),
                  scalar_state("eroded_mass", "kg", "mass that left with them", structure.eroded.mass),
                  scalar_state("eroded_internal", "J", "energy that left with them", structure.eroded.internal),
                  scalar_state("force_work", "J", "what nodal forces have added to the kinetic energy", structure.force_work)}};
    for (Part& part : structure.parts) {
        std::vector<Field> own = std::visit([&](auto& elements) { return elements.state(part.name + "."); }, part.elements);
        std::move(own.begin(), own.end(), std::back_inserter(set.fields));
    }
    return set;
}

std::vector<MeshElement> cells(const Structure& structure)
{
    std::vector<MeshElement> all;
    all.reserve(structure.element_count());
    for (const Part& part : structure.parts) {
        std::visit(
            [&](const auto& elements) {
                for (std::size_t e = 0; e < elements.size(); ++e) {
                    MeshElement cell{elements.shape(e), {}};
                    for (int c = 0; c < node_count(cell.shape); ++c) cell.node[c] = elements.node(e, c);
                    all.push_back(cell);
                }
            },
            part.elements);
    }
    return all;
}

}  // namespace corpuscle
