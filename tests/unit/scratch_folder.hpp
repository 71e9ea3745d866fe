#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace corpuscle {

/// A folder of its own for each test, removed at its end.
class ScratchFolder {
public:
    ScratchFolder()
    {
        static std::atomic<int> number{0};
        path_ = std::filesystem::temp_directory_path() / ("corpuscle_test_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
        std::filesystem::create_directories(path_);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace corpuscle
