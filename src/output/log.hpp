#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace corpuscle {

/// The run's log file: one line an event, stamped with the wall time since the log was opened, on the disk's way as soon as written (a
/// crash loses nothing). Prints nothing on the terminal.
class Log {
public:
    /// Opens `path` and adds to what it holds. Throws Error if it cannot be written.
    explicit Log(const std::filesystem::path& path);

    void line(std::string_view text);
    /// A line that begins with "warning: ".
    void warning(std::string_view text);

private:
    std::filesystem::path path_;
    std::ofstream stream_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace corpuscle
