#include "euler/grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

constexpr double pi = 3.14159265358979323846;

/// All arrays of a state, in a fixed order.
template <class State, class Visit>
void for_each_array(State& state, const std::vector<EulerMaterial>& materials, const Visit& visit)
{
    for (std::size_t m = 0; m < state.mass.size(); ++m) visit("density " + materials[m].name, "kg/m3", state.mass[m]);
    for (int d = 0; d < 3; ++d) visit(std::string("momentum ") + "xyz"[d], "kg/(m2 s)", state.motion[d]);
    visit("energy", "J/m3", state.energy);
    for (std::size_t m = 0; m < state.share.size(); ++m) visit("share " + materials[m].name, "1", state.share[m]);
    for (std::size_t m = 0; m < state.unburnt.size(); ++m) visit("unburnt " + materials[m].name, "kg/m3", state.unburnt[m]);
}

void lay_blocks(EulerGrid& grid)
{
    std::array<std::size_t, 3> counts{};
    for (int d = 0; d < 3; ++d) {
        const std::size_t cells = grid.axes[d].cells(), wanted = std::max<std::size_t>(4, grid.settings.block_cells);
        counts[d] = std::max<std::size_t>(1, (cells + wanted / 2) / wanted);
    }
    grid.block_counts = counts;
    for (std::size_t k = 0; k < counts[2]; ++k) {
        for (std::size_t j = 0; j < counts[1]; ++j) {
            for (std::size_t i = 0; i < counts[0]; ++i) {
                EulerBlock block;
                const std::array<std::size_t, 3> at{i, j, k};
                for (int d = 0; d < 3; ++d) {
                    block.begin[d] = grid.axes[d].cells() * at[d] / counts[d];
                    block.end[d] = grid.axes[d].cells() * (at[d] + 1) / counts[d];
                }
                grid.blocks.push_back(block);
            }
        }
    }
}

void check_grid(const EulerGrid& grid)
{
    if (grid.materials.empty() || grid.materials.size() > most_euler_materials) {
        throw InputError("an Euler grid holds one to four materials", "give fewer gases, or treat alike ones as one");
    }
    const auto live = [&](int d) { return !grid.axes[d].inert(); };
    if (grid.space == EulerSpace::spherical && (live(1) || live(2))) {
        throw InputError("a spherical Euler grid has cells along y or z", "give it one cell there: only the radius counts");
    }
    if (grid.space == EulerSpace::axisymmetric && live(2)) {
        throw InputError("an axisymmetric Euler grid has cells along z", "give it one cell there: x is the radius, y the height");
    }
    for (int d = 0; d < 3; ++d) {
        if (live(d) && grid.axes[d].cells() < 4) {
            throw InputError("an axis of the Euler grid has less than four cells",
                             "give one cell to an axis that nothing moves along, or four");
        }
    }
    if (!(grid.settings.cfl > 0 && grid.settings.cfl < 1)) {
        throw InputError("the cfl number of the Euler grid is not between 0 and 1", "give a value such as 0.8");
    }
    if (grid.settings.block_cells > most_block_cells) throw InputError("blocks of the Euler grid are too large", "give 32 cells at most");
}

/// Square of the distance from a point to the charge that is lit; inert axes do not count [m2].
double way_to_charge(const EulerGrid& grid, const EulerLighting& lit, const Vector3d& at)
{
    double sum = 0;
    for (int d = 0; d < 3; ++d) {
        if (grid.axes[d].inert() || lit.charge.lower[d] > lit.charge.upper[d]) continue;
        const double way = std::max({lit.charge.lower[d] - at[d], at[d] - lit.charge.upper[d], 0.0});
        sum += way * way;
    }
    return sum;
}

}  // namespace

bool lights(const EulerGrid& grid, const EulerExplosive& explosive, const EulerLighting& lit, std::size_t cell)
{
    const Vector3d at = grid.middle(cell);
    const double own = way_to_charge(grid, lit, at);
    return std::all_of(explosive.lightings.begin(), explosive.lightings.end(),
                       [&](const EulerLighting& other) { return own <= way_to_charge(grid, other, at); });
}

double burn_time(const EulerGrid& grid, const EulerExplosive& explosive, std::size_t cell)
{
    double earliest = std::numeric_limits<double>::infinity();
    for (const EulerLighting& lit : explosive.lightings) {
        if (!lights(grid, explosive, lit, cell)) continue;
        Vector3d way = grid.middle(cell) - lit.point;
        for (int d = 0; d < 3; ++d) way[d] = grid.axes[d].inert() ? 0 : way[d];
        earliest = std::min(earliest, lit.time + norm(way) / explosive.detonation_velocity);
    }
    return earliest;
}

EulerAmount& EulerAmount::operator+=(const EulerAmount& other)
{
    for (std::size_t m = 0; m < most_euler_materials; ++m) mass[m] += other.mass[m];
    momentum += other.momentum;
    energy += other.energy;
    return *this;
}

EulerContents& EulerContents::operator+=(const EulerContents& other)
{
    gas += other.gas;
    explosive += other.explosive;
    return *this;
}

std::array<std::size_t, 3> EulerGrid::place(std::size_t cell) const
{
    const std::size_t nx = axes[0].cells(), ny = axes[1].cells();
    return {cell % nx, cell / nx % ny, cell / nx / ny};
}

Vector3d EulerGrid::middle(std::size_t cell) const
{
    const auto at = place(cell);
    return {axes[0].middle(at[0]), axes[1].middle(at[1]), axes[2].middle(at[2])};
}

double EulerGrid::volume(std::size_t cell) const
{
    if (!walls.any()) return whole_volume(cell);
    return walls.is_solid(cell) ? 0.0 : walls.room[cell] * whole_volume(cell);
}

std::size_t EulerGrid::face_number(int axis, const std::array<std::size_t, 3>& at) const
{
    const std::size_t nx = axes[0].cells() + (axis == 0 ? 1 : 0), ny = axes[1].cells() + (axis == 1 ? 1 : 0);
    return at[0] + nx * (at[1] + ny * at[2]);
}

double EulerGrid::whole_volume(std::size_t cell) const
{
    const auto at = place(cell);
    return round() * axes[0].volume[at[0]] * axes[1].volume[at[1]] * axes[2].volume[at[2]];
}

double EulerGrid::round() const
{
    return space == EulerSpace::planar ? 1 : space == EulerSpace::axisymmetric ? 2 * pi : 4 * pi;
}

EulerGrid make_grid(EulerSpace space, const std::array<std::vector<double>, 3>& faces, const std::array<EulerEdge, euler_face_count>& edges,
                    std::vector<EulerMaterial> materials, const EulerSettings& settings)
{
    EulerGrid grid;
    grid.settings = settings;
    grid.space = space;
    grid.edges = edges;
    grid.materials = std::move(materials);
    const int power = space == EulerSpace::planar ? 0 : space == EulerSpace::axisymmetric ? 1 : 2;
    const int given = space == EulerSpace::planar ? 3 : space == EulerSpace::axisymmetric ? 2 : 1;
    for (int d = 0; d < 3; ++d) {  // of axes that are not given, round() has the part
        const bool left_out = d >= given && faces[d].size() <= 2;
        grid.axes[d] = left_out ? euler_axis({-0.5, 0.5}) : euler_axis(faces[d], d == 0 ? power : 0);
    }
    check_grid(grid);
    for (const EulerMaterial& material : grid.materials) {
        check(material.law, material.name);
        grid.laws.push_back(mie_grueneisen(material.law));
    }
    grid.now.mass.resize(grid.materials.size());
    grid.now.share.resize(grid.materials.size() - 1);
    grid.now.unburnt.resize(grid.materials.size());
    for_each_array(grid.now, grid.materials,
                   [&](const std::string&, const char*, std::vector<double>& values) { values.assign(grid.cells(), 0.0); });
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        if (!grid.materials[m].explosive.burns()) grid.now.unburnt[m].clear();
    }
    lay_blocks(grid);
    return grid;
}

double share_of(const EulerState& state, std::size_t material, std::size_t cell)
{
    if (material < state.share.size()) return state.share[material][cell];
    double rest = 1;
    for (const auto& share : state.share) rest -= share[cell];
    return rest;
}

EulerContents contents(const EulerGrid& grid)
{
    const EulerState& now = grid.now;
    return sum_chunks<EulerContents>(grid.cells(), [&](std::size_t begin, std::size_t end) {
        EulerContents part;
        for (std::size_t c = begin; c < end; ++c) {
            const double volume = grid.volume(c);
            part.gas.momentum += volume * Vector3d{now.motion[0][c], now.motion[1][c], now.motion[2][c]};
            part.gas.energy += volume * now.energy[c];
            for (std::size_t m = 0; m < now.mass.size(); ++m) {
                const double waits = now.unburnt[m].empty() ? 0 : now.unburnt[m][c] * volume;
                const EulerExplosive& explosive = grid.materials[m].explosive;
                part.gas.mass[m] += volume * now.mass[m][c] - waits;
                part.gas.energy -= waits * (explosive.energy - explosive.held_energy);
                part.explosive.mass[m] += waits;
                part.explosive.energy += waits * explosive.energy;
            }
        }
        return part;
    });
}

EulerCell look(const EulerGrid& grid, std::size_t cell)
{
    EulerCell found;
    double inverse_gamma = 0, cold = 0, stiff = 0, factor = 0;
    for (std::size_t m = 0; m < grid.laws.size(); ++m) {
        const MieGrueneisen& law = grid.laws[m];
        const double share = share_of(grid.now, m, cell), density = phase_density(law, grid.now.mass[m][cell], share);
        const auto terms = law.cold && share > least_share ? law.cold_terms(density) : MieGrueneisen::Cold{0, 0};
        found.share[m] = share;
        found.density += grid.now.mass[m][cell];
        inverse_gamma += share * law.inverse_gamma(density);
        cold += share * terms.q, stiff += share * terms.z, factor += share * law.g;
    }
    const Vector3d motion{grid.now.motion[0][cell], grid.now.motion[1][cell], grid.now.motion[2][cell]};
    found.velocity = (1 / found.density) * motion;
    found.energy = grid.now.energy[cell] - 0.5 * dot(motion, found.velocity);
    found.pressure = std::max((found.energy + cold) / inverse_gamma, grid.pressure_floor);
    const double stiffness = std::max((stiff + factor * found.pressure) / inverse_gamma, found.pressure);
    found.sound_speed = std::sqrt(stiffness / found.density);
    return found;
}

FieldSet cell_fields(const EulerGrid& grid)
{
    const std::size_t count = grid.cells();
    FieldSet set{"euler", {}};
    const auto add = [&](const char* name, const char* unit, const char* meaning, auto value) {
        set.fields.push_back(
            derived_field<float>(name, unit, meaning, count, [value](std::size_t c) { return static_cast<float>(value(c)); }));
    };
    add("density", "kg/m3", "of all gases together", [&grid](std::size_t c) { return look(grid, c).density; });
    add("pressure", "Pa", "of the mixture", [&grid](std::size_t c) { return look(grid, c).pressure; });
    add("internal_energy", "J/m3", "per volume", [&grid](std::size_t c) { return look(grid, c).energy; });
    set.fields.push_back(derived_field<Vector3f>("velocity", "m/s", "of the mixture", count,
                                                 [&grid](std::size_t c) { return Vector3f(look(grid, c).velocity); }));
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        set.fields.push_back(derived_field<float>("share_" + grid.materials[m].name, "1", "share of the volume", count,
                                                  [&grid, m](std::size_t c) { return static_cast<float>(share_of(grid.now, m, c)); }));
    }
    if (!grid.walls.solid.empty()) {
        set.fields.push_back(derived_field<float>("solid", "1", "1: within a solid, where there is no gas", count,
                                                  [&grid](std::size_t c) { return grid.walls.is_solid(c) ? 1.0f : 0.0f; }));
    }
    return set;
}

FieldSet state(EulerGrid& grid)
{
    FieldSet set{"euler", {}};
    for_each_array(grid.now, grid.materials, [&](std::string name, const char* unit, std::vector<double>& values) {
        std::replace(name.begin(), name.end(), ' ', '_');
        set.fields.push_back(stored_field(std::move(name), unit, "state of the cells", values));
    });
    Field passages{"passages", "SI", "given to the edges: masses, momentum, energy", Scalar::float64, 8, euler_face_count, {}, {}};
    passages.gather = [&grid](void* out) {
        double* to = static_cast<double*>(out);
        for (const EulerAmount& face : grid.passages) {
            to = std::copy(face.mass.begin(), face.mass.end(), to);
            for (const double value : {face.momentum.x, face.momentum.y, face.momentum.z, face.energy}) *to++ = value;
        }
    };
    passages.restore = [&grid](const void* in, std::size_t count) {
        const double* from = static_cast<const double*>(in);
        for (std::size_t f = 0; f < std::min<std::size_t>(count, euler_face_count); ++f, from += 8) {
            std::copy(from, from + 4, grid.passages[f].mass.begin());
            grid.passages[f].momentum = {from[4], from[5], from[6]};
            grid.passages[f].energy = from[7];
        }
    };
    set.fields.push_back(std::move(passages));
    Field floor{"pressure_floor", "Pa", "least pressure that a cell shows", Scalar::float64, 1, 1, {}, {}};
    floor.gather = [&grid](void* out) { *static_cast<double*>(out) = grid.pressure_floor; };
    floor.restore = [&grid](const void* in, std::size_t) { grid.pressure_floor = *static_cast<const double*>(in); };
    set.fields.push_back(std::move(floor));
    return set;
}

}  // namespace corpuscle
