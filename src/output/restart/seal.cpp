#include "output/restart/seal.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.hpp"
#include "output/checksum.hpp"

namespace corpuscle {

namespace {

/// The last bytes of a sealed file.
struct Footer {
    std::array<char, 16> mark{'c', 'o', 'r', 'p', 'u', 's', 'c', 'l', 'e', ' ', 's', 'e', 'a', 'l', ' ', '1'};
    std::uint64_t length = 0;  ///< bytes before the footer
    std::uint64_t checksum = 0;
};

/// The footer that fits the first `length` bytes of a file; its length says how many could be read.
Footer footer_of(const std::filesystem::path& path, std::uint64_t length)
{
    std::ifstream stream(path, std::ios::binary);
    std::vector<std::byte> buffer(std::size_t{1} << 20U);
    Checksum checksum;
    Footer footer;
    while (stream && footer.length < length) {
        const std::uint64_t wanted = std::min<std::uint64_t>(buffer.size(), length - footer.length);
        stream.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(wanted));
        const auto got = static_cast<std::size_t>(stream.gcount());
        checksum.add({buffer.data(), got});
        footer.length += got;
    }
    footer.checksum = checksum.value();
    return footer;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const char* what)
{
    throw Error(fmt::format("the saved state '{}' is not whole: {}", path.string(), what),
                "resume from an older one, or run the case anew");
}

}  // namespace

void seal_file(const std::filesystem::path& path)
{
    const std::uint64_t length = std::filesystem::file_size(path);
    const Footer footer = footer_of(path, length);
    std::ofstream stream(path, std::ios::binary | std::ios::app);
    stream.write(reinterpret_cast<const char*>(&footer), sizeof footer);
    stream.close();
    if (!stream || footer.length != length) throw Error(fmt::format("cannot write '{}'", path.string()), "is the disk full?");
}

void check_seal(const std::filesystem::path& path)
{
    std::error_code problem;
    const std::uint64_t size = std::filesystem::file_size(path, problem);
    if (problem) refuse(path, problem.message().c_str());
    if (size < sizeof(Footer)) refuse(path, "it is too short");
    Footer stored;
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(size - sizeof stored));
    stream.read(reinterpret_cast<char*>(&stored), sizeof stored);
    if (!stream || stored.mark != Footer{}.mark) refuse(path, "its end is missing");
    if (stored.length != size - sizeof stored) refuse(path, "its length is not the one it was saved with");
    if (footer_of(path, stored.length).checksum != stored.checksum) refuse(path, "its checksum does not fit");
}

}  // namespace corpuscle
