#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace corpuscle {

/// Wall time since a moment [s].
[[nodiscard]] double wall_seconds_since(std::chrono::steady_clock::time_point start);

/// Processor time of this program, all threads [s].
[[nodiscard]] double cpu_seconds();

/// Largest resident memory of this program so far [byte].
[[nodiscard]] std::uint64_t peak_memory();

/// Name, version and compiler of this program.
[[nodiscard]] std::string program_text();

/// The command line that started it.
[[nodiscard]] std::string command_text();

}  // namespace corpuscle
