#pragma once

#include <filesystem>

namespace corpuscle {

/// Adds a footer to a finished file: a mark, its length and a checksum over all its bytes. (HDF5 ignores what follows its own end.) Throws
/// Error.
void seal_file(const std::filesystem::path& path);

/// Throws Error, saying what is wrong, unless the file ends in the footer that fits its bytes.
void check_seal(const std::filesystem::path& path);

}  // namespace corpuscle
