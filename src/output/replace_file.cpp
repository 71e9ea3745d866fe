#include "output/replace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace corpuscle {

namespace {

[[noreturn]] void refuse(const char* verb, const std::filesystem::path& path, int code)
{
    throw Error(fmt::format("cannot {} '{}': {}", verb, path.string(), std::strerror(code)),
                "check that the folder is writable and the disk not full");
}

/// Waits until the disk holds what was written to a file or folder.
void synchronize(const std::filesystem::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) refuse("open", path, errno);
    const int result = ::fsync(descriptor);
    const int code = errno;
    ::close(descriptor);
    // Some file systems cannot synchronise a folder (EINVAL): the rename is then as safe as they make it.
    if (result != 0 && code != EINVAL) refuse("flush", path, code);
}

}  // namespace

std::filesystem::path aside(const std::filesystem::path& path)
{
    std::filesystem::path name = path;
    name += ".part";
    return name;
}

void finish_aside(const std::filesystem::path& path, Durability durability)
{
    const std::filesystem::path part = aside(path);
    if (durability == Durability::disk) synchronize(part);
    std::error_code problem;
    std::filesystem::rename(part, path, problem);
    if (problem) refuse("rename to", path, problem.value());
    if (durability == Durability::disk) synchronize(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."));
}

void replace_file(const std::filesystem::path& path, std::string_view text, Durability durability)
{
    const std::filesystem::path part = aside(path);
    errno = 0;
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    if (!stream) refuse("create", part, errno);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) refuse("write", part, errno);
    finish_aside(path, durability);
}

std::string read_file(const std::filesystem::path& path)
{
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream || std::filesystem::is_directory(path)) {
        throw Error(fmt::format("cannot read '{}': {}", path.string(), std::strerror(errno != 0 ? errno : EISDIR)), "check the path");
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace corpuscle
