#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "output/restart/restart_file.hpp"

namespace corpuscle {

/// The folder of saved states: keeps the newest two, each whole.
class RestartFolder {
public:
    /// A folder that exists, or will before the first save.
    explicit RestartFolder(std::filesystem::path folder, std::size_t kept = 2);

    /// Saves a state beside the older ones, then removes all but the newest `kept`. Gives the file.
    std::filesystem::path save(const RestartContent& content) const;

    /// The saved states, oldest first.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

    /// Opens the newest state that is whole; what was wrong with newer ones is added to `remarks`, for the log. Throws InputError if there
    /// is none.
    [[nodiscard]] RestartFile open_newest(std::vector<std::string>& remarks) const;

private:
    std::filesystem::path folder_;
    std::size_t kept_;
};

}  // namespace corpuscle
