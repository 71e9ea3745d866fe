#include "output/log.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>

#include "base/error.hpp"

namespace corpuscle {

Log::Log(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::app), start_(std::chrono::steady_clock::now())
{
    if (!stream_)
        throw Error(fmt::format("cannot write the log '{}': {}", path.string(), std::strerror(errno)), "check that the folder is writable");
    line(fmt::format("log opened {:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr))));
}

void Log::line(std::string_view text)
{
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    stream_ << fmt::format("{:10.3f} s  {}\n", seconds, text) << std::flush;
    if (!stream_) throw Error(fmt::format("cannot write the log '{}'", path_.string()), "is the disk full?");
}

void Log::warning(std::string_view text)
{
    line("warning: " + std::string(text));
}

}  // namespace corpuscle
