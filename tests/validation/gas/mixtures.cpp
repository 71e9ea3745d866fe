/// Mixtures of unlike particles: what `tools/validation/mixtures.py` makes tables of. Argument: which part.
#include <cstdio>
#include <string_view>

#include "verification/gas/kinetics/mixture.hpp"
#include "verification/gas/kinetics/two_mass_tube.hpp"

namespace {

using namespace corpuscle;

struct Law {
    const char* name;
    EquationOfState law;
};

/// Every pair of laws at three mass ratios: Dalton's pressure, the split of energy, its drift, what is conserved.
void pairs()
{
    const std::array<Law, 3> laws{
        {{"ideal", IdealGas{1.4}}, {"Noble-Abel", NobleAbel{1.3, 0.3, 1630}}, {"JWL", Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}}}};
    constexpr std::size_t total = 20000;
    for (std::size_t a = 0; a < laws.size(); ++a) {
        for (std::size_t b = a; b < laws.size(); ++b) {
            for (const double ratio : {0.01, 0.1, 1.0, 10.0, 100.0}) {
                Mixture set{.law = {laws[a].law, laws[b].law}, .density = {800, 400}, .energy = {4e6, 2e6}};
                set.count[0] = static_cast<std::size_t>(static_cast<double>(total) * 2 * ratio / (1 + 2 * ratio));
                set.count[1] = total - set.count[0];
                const Mixed found = mix(set, 500, 10, 100);
                std::printf(R"({"first": "%s", "second": "%s", "ratio": %g, "few": %zu, "pressure": %.4f, "pressure_error": %.4f, )"
                            R"("split": %.4f, "split_error": %.4f, "drift": %.4f, "drift_error": %.4f, "energy": %.1e, "momentum": %.1e, )"
                            R"("collisions": %.0f})"
                            "\n",
                            laws[a].name, laws[b].name, ratio, std::min(set.count[0], set.count[1]), found.pressure, found.pressure_error,
                            found.split, found.split_error, found.drift, found.drift_error, found.energy_error, found.momentum_error,
                            found.collisions);
                std::fflush(stdout);
            }
        }
    }
}

/// Collisions until two temperatures are one, and Sod's tube with unlike particles in its halves.
void ratios()
{
    for (const double ratio : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}) {
        Mixture set{.law = {IdealGas{5.0 / 3}, IdealGas{5.0 / 3}}, .density = {ratio, 1}, .energy = {2 / ratio, 1}};
        const double collisions = collisions_to_equal_temperatures(set);
        TubeErrors mean;
        constexpr int seeds = 3;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const TubeErrors found = run_two_mass_tube({.ratio = ratio, .count = 60000, .seed = seed});
            mean.density += found.density / seeds, mean.velocity += found.velocity / seeds, mean.pressure += found.pressure / seeds;
            mean.mixing += found.mixing / seeds, mean.contact += found.contact / seeds;
        }
        std::printf(
            R"({"ratio": %g, "collisions": %.2f, "density": %.4f, "velocity": %.4f, "pressure": %.4f, "mixing": %.4f, "contact": %.4f})"
            "\n",
            ratio, collisions, mean.density, mean.velocity, mean.pressure, mean.mixing, mean.contact);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int count, char** words)
{
    const std::string_view part = count > 1 ? words[1] : "";
    if (part == "pairs") pairs();
    if (part == "ratios") ratios();
}
