#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corpuscle {

/// Whether a finished file must have reached the disk (a power cut loses nothing) or only the system (a kill loses nothing).
enum class Durability { system, disk };

/// The name a file has while it is being written, in the same folder: "x" -> "x.part".
[[nodiscard]] std::filesystem::path aside(const std::filesystem::path& path);

/// Gives the file written at aside(path) its name, replacing an older one at once. Throws Error if the system refuses.
void finish_aside(const std::filesystem::path& path, Durability durability);

/// Writes `text` as the whole content of `path`: at every moment the file is the old one or the new one, never a torn one. Throws Error.
void replace_file(const std::filesystem::path& path, std::string_view text, Durability durability = Durability::system);

/// The whole content of a file. Throws Error if it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace corpuscle
