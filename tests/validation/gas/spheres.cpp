// Hard spheres in a closed box: pressure on its walls, by the count of bounces, and by the law of Carnahan and Starling with
// what the walls take. One JSON object a line: packing, gamma, step (cfl) and what was measured.
//     validate_spheres [particles] [packing gamma cfl]

#include <cstdio>
#include <cstdlib>

#include "../../verification/gas/sphere_box.hpp"

int main(int argc, char** argv)
{
    using namespace corpuscle;
    const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 8000;
    const auto print = [&](double packing, double gamma, double cfl) {
        const SphereBox box = measure_box({packing, gamma, cfl, count, 200, 40, 16});
        std::printf(
            "{\"packing\": %.4f, \"gamma\": %.4f, \"cfl\": %.3f, \"particles\": %zu, \"packing_middle\": %.5f, \"law\": %.5f, "
            "\"wall\": %.5f, \"wall_sigma\": %.5f, \"bounces\": %.5f, \"bounces_sigma\": %.5f, \"translational\": %.5f, "
            "\"met_a_step\": %.4f, \"energy_error\": %.2e}\n",
            packing, gamma, cfl, count, box.packing_middle, box.law, box.wall.mean, box.wall.error, box.bounces.mean, box.bounces.error,
            box.translational.mean, box.met_a_step, box.energy_error);
        std::fflush(stdout);
    };
    if (argc > 4) {
        print(std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4]));
        return 0;
    }
    for (const double packing : {0.01, 0.05, 0.1, 0.2, 0.3}) print(packing, 5.0 / 3, 0.4);
    for (const double gamma : {1.3, 1.4})
        for (const double packing : {0.05, 0.2}) print(packing, gamma, 0.4);
    for (const double cfl : {0.1, 0.2, 0.8}) print(0.2, 1.4, cfl);
    return 0;
}
