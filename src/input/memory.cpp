#include "input/memory.hpp"

#include <array>
#include <fstream>

#include <fmt/format.h>

namespace corpuscle {

namespace {

// Resident a particle: 32 for itself, at most 64 with its sort, cells and pending flights, and as much again while a state is
// saved or a picture written. A shell with five points, its nodes, facets and their tree.
constexpr std::size_t bytes_a_particle = 128;
constexpr std::size_t bytes_an_element = 2048;
constexpr std::size_t bytes_of_program = 64'000'000;

}  // namespace

MachineMemory machine_memory()
{
    MachineMemory memory;
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (std::size_t kilobytes = 0; file >> name >> kilobytes; std::getline(file, unit)) {
        if (name == "MemTotal:") memory.total = kilobytes * 1024;
        if (name == "MemAvailable:") memory.available = kilobytes * 1024;
    }
    return memory;
}

std::size_t needed_memory(std::size_t particles, std::size_t elements)
{
    return bytes_of_program + bytes_a_particle * particles + bytes_an_element * elements;
}

std::size_t check_memory(std::size_t particles, std::size_t elements, const Place& place, const MachineMemory& machine)
{
    const std::size_t needed = needed_memory(particles, elements);
    if (machine.total == 0 || needed <= machine.total) return needed;
    const std::size_t fixed = needed_memory(0, elements);
    const std::size_t room = machine.total > fixed ? (machine.total - fixed) / bytes_a_particle : 0;
    throw InputError(fmt::format("{} particles and {} elements need about {}, this machine has {}", particles, elements, bytes_text(needed),
                                 bytes_text(machine.total)),
                     fmt::format("expected at most about {} particles here", room), place);
}

std::string bytes_text(std::size_t bytes)
{
    constexpr std::array<const char*, 5> units{"bytes", "kB", "MB", "GB", "TB"};
    double size = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (size >= 1000 && unit + 1 < units.size()) {
        size /= 1000;
        ++unit;
    }
    return fmt::format("{:.3g} {}", size, units[unit]);
}

}  // namespace corpuscle
