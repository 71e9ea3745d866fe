#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle {

/// What the command line gave, for all commands.
struct Options {
    std::string subject;                ///< case, folder, name or key
    std::vector<std::string> settings;  ///< --set key=value
    std::string out;                    ///< --out, empty: chosen
    int threads = 0;                    ///< 0: as many as the machine has
    std::string at;                     ///< --at, distances such as 0.5,1,2 [m]
    double cells = 100;                 ///< --cells
    bool quiet = false;
    bool force = false;
    bool markdown = false;
    bool json = false;
    std::filesystem::path program;  ///< of this executable

    /// Folders of presets that came with the program.
    [[nodiscard]] std::vector<std::filesystem::path> installed_share() const;
};

}  // namespace corpuscle
