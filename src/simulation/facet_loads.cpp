#include "simulation/facet_loads.hpp"

#include <algorithm>

#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Half the cross product of a facet's edges at the end of the step [m2].
Vector3d shown_area(const Structure& structure, const Facet& facet)
{
    const std::span<const Vector3d> at = structure.nodes.path().end;
    return 0.5 * cross(at[facet.node[1]] - at[facet.node[0]], at[facet.node[2]] - at[facet.node[0]]);
}

/// Cell array of one number an element.
Field cell_array(const char* name, const char* unit, const char* meaning, const std::vector<double>& values)
{
    return derived_field<float>(name, unit, meaning, values.size(), [&values](std::size_t e) { return static_cast<float>(values[e]); });
}

/// What each element has been pressed with since the picture before, over the time since. [Pa]
std::vector<double> rise(const std::vector<double>& now, const std::vector<double>& before, double interval)
{
    std::vector<double> pressure(now.size());
    if (interval > 0) for_each(now.size(), [&](std::size_t e) { pressure[e] = (now[e] - before[e]) / interval; });
    return pressure;
}

}  // namespace

FacetLoads::FacetLoads(const Model& model) : model_(model), time_{model.start_time}
{
    before_.upper.resize(model.structure.element_count());
    before_.lower.resize(model.structure.element_count());
}

/// Particles tell their sides apart; what loads and gases on a grid have given on the whole counts for the side that it points away from.
FacetLoads::Sides FacetLoads::impulses() const
{
    const Structure& structure = model_.structure;
    const FacetPress& gas = model_.gas_structure.facet_press();
    Sides sides{std::vector<double>(structure.element_count()), std::vector<double>(structure.element_count())};
    std::vector<double> area(structure.element_count());
    for (std::size_t f = 0; f < structure.surface.facets.size(); ++f) {
        const Facet& facet = structure.surface.facets[f];
        if (facet.solid && structure.surface.is_hidden(f)) continue;
        const Vector3d own = shown_area(structure, facet);
        const double size = norm(own);
        Vector3d loads = model_.grid_walls.facet_impulse()[f];
        for (const auto& load : model_.loads) loads += load->facet_impulse()[f];
        const double along = size > 0 ? dot(loads, own) / size : 0.0;
        area[facet.element] += size;
        sides.upper[facet.element] += gas.upper[f] + std::max(0.0, -along);
        sides.lower[facet.element] += gas.lower[f] + std::max(0.0, along);
    }
    for (std::size_t e = 0; e < area.size(); ++e) {
        const double inverse = area[e] > 0 ? 1 / area[e] : 0.0;
        sides.upper[e] *= inverse;
        sides.lower[e] *= inverse;
    }
    return sides;
}

FieldSet FacetLoads::picture(double time)
{
    impulse_ = impulses();
    const double interval = time - time_[0];
    pressure_ = {rise(impulse_.upper, before_.upper, interval), rise(impulse_.lower, before_.lower, interval)};
    before_ = impulse_;
    time_[0] = time;
    return {"structure loads",
            {cell_array("load_impulse_upper", "Pa s", "specific impulse of gas and loads on the upper side", impulse_.upper),
             cell_array("load_impulse_lower", "Pa s", "specific impulse of gas and loads on the lower side", impulse_.lower),
             cell_array("load_pressure_upper", "Pa", "pressure of gas and loads on the upper side, mean since the dump before",
                        pressure_.upper),
             cell_array("load_pressure_lower", "Pa", "pressure of gas and loads on the lower side, mean since the dump before",
                        pressure_.lower)}};
}

FieldSet FacetLoads::state()
{
    return {"facet_loads",
            {stored_field("upper", "Pa s", "specific impulse on upper sides at the last dump", before_.upper),
             stored_field("lower", "Pa s", "specific impulse on lower sides at the last dump", before_.lower),
             stored_field("time", "s", "of the last dump", time_)}};
}

}  // namespace corpuscle
