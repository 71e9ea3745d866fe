#include "app/waiting.hpp"

#include <unistd.h>

#include <cstdlib>

namespace corpuscle {

void settle_waiting(char** argv)
{
    if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
    // libgomp's own default spins for milliseconds: on a machine that others use too, a step then costs many times its work.
    if (setenv("GOMP_SPINCOUNT", "1000", 0) == 0) execv("/proc/self/exe", argv);
}

}  // namespace corpuscle
