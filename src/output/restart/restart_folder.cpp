#include "output/restart/restart_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <ranges>
#include <utility>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::string_view prefix = "state_";

/// The number in "state_000012.hdf", nothing for other names.
std::optional<std::uint64_t> number_of(const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    if (!name.starts_with(prefix) || path.extension() != ".hdf") return std::nullopt;
    std::uint64_t number = 0;
    const char* end = name.data() + name.size() - 4;
    const auto result = std::from_chars(name.data() + prefix.size(), end, number);
    if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
    return number;
}

}  // namespace

RestartFolder::RestartFolder(std::filesystem::path folder, std::size_t kept) : folder_(std::move(folder)), kept_(kept) {}

std::vector<std::filesystem::path> RestartFolder::files() const
{
    std::vector<std::filesystem::path> found;
    if (!std::filesystem::is_directory(folder_)) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        if (number_of(entry.path())) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return number_of(a) < number_of(b); });
    return found;
}

std::filesystem::path RestartFolder::save(const RestartContent& content) const
{
    std::filesystem::create_directories(folder_);
    std::vector<std::filesystem::path> states = files();
    const std::uint64_t number = states.empty() ? 1 : *number_of(states.back()) + 1;
    states.push_back(folder_ / fmt::format("{}{:06}.hdf", prefix, number));
    write_restart(states.back(), content);
    while (states.size() > kept_) {
        std::filesystem::remove(states.front());
        states.erase(states.begin());
    }
    return states.back();
}

RestartFile RestartFolder::open_newest(std::vector<std::string>& remarks) const
{
    const std::vector<std::filesystem::path> states = files();
    for (const std::filesystem::path& state : std::views::reverse(states)) {
        try {
            return RestartFile(state);
        } catch (const InputError&) {
            throw;  // whole, but of another version: an older one will not fit either
        } catch (const Error& problem) {
            remarks.push_back(problem.problem());
        }
    }
    std::string reasons;
    for (const std::string& remark : remarks) reasons += "\n  " + remark;
    throw InputError(fmt::format("no whole saved state in '{}'{}", folder_.string(), reasons), "run the case anew");
}

}  // namespace corpuscle
