#include "input/memory.hpp"

#include <array>
#include <fstream>

#include <fmt/format.h>

namespace corpuscle {

namespace {

// Resident a particle: 32 for itself, at most 64 with its sort, cells and pending flights, and as much again while a state is
// saved or a picture written. A cell: four numbers, and of each gas its density, its share and what of it waits to burn, now and at
// the end of the step, and what is in hand; its room and openings where walls are about. A shell with five points, its nodes, facets and
// their tree.
constexpr std::size_t bytes_a_particle = 128;
constexpr std::size_t bytes_an_element = 2048;
constexpr std::size_t bytes_a_cell = 64;
constexpr std::size_t bytes_a_gas_of_a_cell = 48;
constexpr std::size_t bytes_of_walls_a_cell = 60;
constexpr std::size_t bytes_of_program = 40'000'000;

std::size_t for_a_cell(const ModelSize& size)
{
    return bytes_a_cell + bytes_a_gas_of_a_cell * size.gases + (size.walls ? bytes_of_walls_a_cell : 0);
}

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

std::size_t needed_memory(const ModelSize& size)
{
    return bytes_of_program + bytes_a_particle * size.particles + bytes_an_element * size.elements + for_a_cell(size) * size.cells;
}

std::size_t check_memory(const ModelSize& size, const Place& place, const MachineMemory& machine)
{
    const std::size_t needed = needed_memory(size);
    if (machine.total == 0 || needed <= machine.total) return needed;
    const std::size_t fixed = needed_memory({0, size.elements});
    const std::size_t room = machine.total > fixed ? machine.total - fixed : 0;
    const bool grid = size.cells > 0;
    throw InputError(fmt::format("{} and {} elements need about {}, this machine has {}",
                                 grid ? fmt::format("{} cells", size.cells) : fmt::format("{} particles", size.particles), size.elements,
                                 bytes_text(needed), bytes_text(machine.total)),
                     grid ? fmt::format("expected at most about {} cells here", room / for_a_cell(size))
                          : fmt::format("expected at most about {} particles here", room / bytes_a_particle),
                     place);
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
