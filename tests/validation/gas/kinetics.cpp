/// Kinetics of the particle gas against theory: what `tools/validation/kinetics.py` makes tables of. Argument: which part.
#include <cstdio>
#include <string_view>

#include "verification/gas/kinetics/expansion.hpp"
#include "verification/gas/kinetics/normal_shock.hpp"
#include "verification/gas/kinetics/relaxation.hpp"
#include "verification/gas/kinetics/vacuum.hpp"
#include "verification/gas/kinetics/vessel.hpp"
#include "verification/gas/kinetics/vortex_decay.hpp"

namespace {

using namespace corpuscle;

const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
constexpr double tnt_energy = 7e9 / 1630;

/// Shock structure: one line a run, with its profile.
void shocks()
{
    for (const double mach : {2.0, 8.0}) {
        for (const std::uint64_t seed : {1, 2}) {
            const ShockFound found = run({.mach = mach, .path = 10, .width = 14, .formed = 12, .end = 30, .seed = seed});
            std::printf(
                R"({"mach": %g, "seed": %d, "ratio": %.5f, "error": %.5f, "speed": %.4f, "behind": %.4f, "jump": %.4f, "profile": [)", mach,
                static_cast<int>(seed), found.thickness_ratio, found.error, found.speed / mach, found.density_ratio,
                ShockJump(mach).density);
            for (std::size_t i = 0; i < found.place.size(); i += 2)
                std::printf("%s[%.2f, %.4f]", i ? ", " : "", found.place[i], found.density[i]);
            std::puts("]}");
            std::fflush(stdout);
        }
    }
}

/// Rotational relaxation over the relaxation number.
void relaxations()
{
    for (const double number : {1.0, 2.0, 3.0, 5.0, 10.0, 20.0}) {
        const RelaxationFound found = relax({.relaxation = number, .count = 100000, .to_the_end = number == 2});
        const double expected = relaxation_rate(internal_freedoms(1.4), number);
        std::printf(
            R"({"relaxation": %g, "rate": %.5f, "error": %.5f, "theory": %.5f, "translational": %.1f, "internal": %.1f, "kelvin": %.1f})"
            "\n",
            number, found.rate, found.rate_error, expected, found.translational, found.internal, found.error);
        std::fflush(stdout);
    }
}

/// Viscosity over the mean free path and the size of cells.
void viscosities()
{
    for (const std::uint32_t limit : {16u, 8u, 4u}) {
        for (const double path : {0.1, 0.25, 0.5, 0.75, 1.0, 2.0, 4.0}) {
            if (limit < 16 && (path < 0.2 || path > 1)) continue;
            VortexDecay set{.mean_free_path = path, .side = path > 2 ? 80.0 : 40.0, .height = path > 2 ? 25.0 : 100.0, .cell_limit = limit};
            const VortexFound found = decay(set);
            std::printf(R"({"kappa": %g, "limit": %u, "viscosity": %.4f, "error": %.4f, "spheres": %.4f, "cells": %.4f, "path": %.4f, )"
                        R"("distance": %.4f, "rate": %.4f})"
                        "\n",
                        path, limit, found.viscosity, found.error, found.kinetic, found.cells, found.path, found.pair_distance, found.rate);
            std::fflush(stdout);
        }
    }
}

/// Escape into a vacuum over the co-volume, with gas of growing length.
void escapes()
{
    for (const double length : {40.0, 80.0, 160.0, 320.0}) {
        for (const double filled : {0.0, 0.1, 0.3, 0.6}) {
            const Escape found = escape({.filled = filled, .length = length, .width = 14});
            std::printf(R"({"length": %g, "filled": %g, "edge": %.4f, "error": %.4f, "invariant": %.4f})"
                        "\n",
                        length, filled, found.edge, found.edge_error, found.invariant);
            std::fflush(stdout);
        }
    }
}

/// Slow expansion along the isentrope; a line each moment, at three speeds of the walls.
void expansions()
{
    const auto follow = [](const char* name, const EquationOfState& law, double density, double energy) {
        Expansion set{.law = law, .density = density, .energy = energy, .side = 20, .mach = 0.05};
        const std::vector<Expanded> fast = expand(set);
        set.mach /= 2;
        const std::vector<Expanded> slow = expand(set);
        set.mach /= 2;
        const std::vector<Expanded> slower = expand(set);
        for (std::size_t i = 0; i < slow.size(); ++i)
            std::printf(R"({"law": "%s", "volume": %.3f, "isentrope": %.5f, "fast": %.5f, "slow": %.5f, "slower": %.5f})"
                        "\n",
                        name, slow[i].volume_ratio, slow[i].isentrope, fast[i].energy / fast[i].isentrope,
                        slow[i].energy / slow[i].isentrope, slower[i].energy / slower[i].isentrope);
        std::fflush(stdout);
    };
    follow("ideal, gamma 1.4", IdealGas{1.4}, 1, 1);
    follow("Noble-Abel, b 0.1", NobleAbel{1.3, 0.1, 1}, 1, 1);
    follow("Noble-Abel, b 0.3", NobleAbel{1.3, 0.3, 1}, 1, 1);
    follow("Noble-Abel, b 0.6", NobleAbel{1.3, 0.6, 1}, 1, 1);
    follow("JWL of TNT", tnt, 1630, tnt_energy);
}

/// A charge burns in a closed vessel.
void vessels()
{
    const auto burn = [](const char* name, const Vessel& set) {
        const VesselFound found = burn_in_vessel(set);
        std::printf(R"({"law": "%s", "volume": %g, "air": %g, "pressure": %.5f, "error": %.5f, "expected_mpa": %.5g, "share": %.4f})"
                    "\n",
                    name, set.expansion, set.air_density, found.pressure, found.error, found.expected * 1e-6, found.first_share);
        std::fflush(stdout);
    };
    for (const double expansion : {3.0, 30.0}) {
        burn("ideal", {.law = IdealGas{1.3}, .expansion = expansion});
        burn("Noble-Abel, b 0.3", {.law = NobleAbel{1.3, 0.3, 1630}, .expansion = expansion});
        burn("JWL of TNT", {.law = tnt, .expansion = expansion});
    }
    for (const double air : {1.2, 12.0}) {
        burn("ideal", {.law = IdealGas{1.3}, .expansion = 100, .air_density = air});
        burn("Noble-Abel, b 0.3", {.law = NobleAbel{1.3, 0.3, 1630}, .expansion = 100, .air_density = air});
        burn("JWL of TNT", {.law = tnt, .expansion = 100, .air_density = air});
    }
}

}  // namespace

int main(int count, char** words)
{
    const std::string_view part = count > 1 ? words[1] : "";
    if (part == "shock") shocks();
    if (part == "relaxation") relaxations();
    if (part == "viscosity") viscosities();
    if (part == "escape") escapes();
    if (part == "expansion") expansions();
    if (part == "vessel") vessels();
}
