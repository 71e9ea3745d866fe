#pragma once

#include <cstddef>
#include <string>

#include "base/error.hpp"

namespace corpuscle {

/// Memory that this machine has and that is free now [bytes]; 0 where the system does not say (/proc/meminfo).
struct MachineMemory {
    std::size_t total = 0;
    std::size_t available = 0;
};
[[nodiscard]] MachineMemory machine_memory();

/// What a run's memory depends on.
struct ModelSize {
    std::size_t particles = 0;
    std::size_t elements = 0;
    std::size_t cells = 0;  ///< of a grid of gases
    std::size_t gases = 0;  ///< in that grid
    bool walls = false;     ///< parts stand in it
};

/// Bytes a run will need: particles with their sort and files, elements with their nodes, cells with the step to come, the program itself.
[[nodiscard]] std::size_t needed_memory(const ModelSize& size);

/// Refuses what needs more than the machine has, at the place of the count of particles or cells. Returns the bytes needed.
std::size_t check_memory(const ModelSize& size, const Place& place, const MachineMemory& machine);

/// "3.2 GB".
[[nodiscard]] std::string bytes_text(std::size_t bytes);

}  // namespace corpuscle
