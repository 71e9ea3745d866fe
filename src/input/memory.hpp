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

/// Bytes a run will need: particles with their sort and files, elements with their nodes, the program itself.
[[nodiscard]] std::size_t needed_memory(std::size_t particles, std::size_t elements);

/// Refuses what needs more than the machine has, at the place of the particle count. Returns the bytes needed.
std::size_t check_memory(std::size_t particles, std::size_t elements, const Place& place, const MachineMemory& machine);

/// "3.2 GB".
[[nodiscard]] std::string bytes_text(std::size_t bytes);

}  // namespace corpuscle
