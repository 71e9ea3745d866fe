#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "../../verification/contact/honeycomb.hpp"

// Hits of particles on many facets in a hostile arrangement, and how many particles came through (docs/validation.md). `validate_leaks
// HITS` makes as many hits, 1e8 unless told, the later half while facets erode.

namespace corpuscle {
namespace {

/// Rooms, their gas and what the contact has counted.
struct Flood {
    Honeycomb rooms{48, 16, 1.5, 400'000, 3000};
    GasStructureContact contact{rooms.gas, rooms.structure};
    std::uint64_t hits = 0;
    std::size_t astray = 0;
    double fastest = 0;  ///< of any node so far [m/s]
    std::clock_t begun = std::clock();

    void step()
    {
        rooms.step(contact, 1e-5);
        hits = std::accumulate(contact.facet_hits().begin(), contact.facet_hits().end(), std::uint64_t{0});
        astray = rooms.astray();
        for (const Vector3d& velocity : rooms.structure.nodes.velocity) fastest = std::max(fastest, norm(velocity));
    }

    /// Facets that have been hit.
    [[nodiscard]] std::size_t facets_hit() const
    {
        const std::vector<std::uint64_t>& each = contact.facet_hits();
        return each.size() - static_cast<std::size_t>(std::count(each.begin(), each.end(), 0u));
    }

    void print(const char* stage) const
    {
        std::printf(R"({"stage": "%s", "facets": %zu, "facets_hit": %zu, "particles": %zu, "steps": %llu, "hits": %llu, )", stage,
                    rooms.facets(), facets_hit(), rooms.gas.particles.size(), static_cast<unsigned long long>(rooms.clock.step()),
                    static_cast<unsigned long long>(hits));
        std::printf("\"eroded\": %zu, \"fastest_node\": %.0f, \"astray\": %zu, \"trapped\": %llu, \"cpu_s\": %.1f}\n", rooms.eroded(),
                    fastest, astray, static_cast<unsigned long long>(contact.trapped()),
                    static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
        std::fflush(stdout);
    }
};

/// Flies until there have been so many hits, or a particle has gone astray.
void fly_among_rooms(double wanted)
{
    Flood flood;
    for (const double share : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
        const bool eroding = share >= 0.5;
        while (static_cast<double>(flood.hits) < (share + 0.1) * wanted && flood.astray == 0) {
            if (eroding) flood.rooms.erode(10);
            flood.step();
        }
        flood.print(eroding ? "eroding" : "whole");
    }
}

}  // namespace
}  // namespace corpuscle

int main(int count, char** words)
{
    corpuscle::fly_among_rooms(count > 1 ? std::atof(words[1]) : 1e8);
}
