#include "output/history/history.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>

#include "base/error.hpp"

namespace corpuscle {

History::History(const std::filesystem::path& path, std::vector<HistoryColumn> columns, std::ios::openmode mode)
    : path_(path), columns_(std::move(columns)), stream_(path, mode)
{
    if (!stream_)
        throw Error(fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)), "check that the folder is writable");
}

History::History(const std::filesystem::path& path, std::vector<HistoryColumn> columns) : History(path, std::move(columns), std::ios::trunc)
{
    stream_ << history_header(columns_) << '\n' << std::flush;
    if (!stream_) throw Error(fmt::format("cannot write '{}'", path_.string()), "is the disk full?");
}

History History::resume(const std::filesystem::path& path, std::vector<HistoryColumn> columns, double time)
{
    if (!std::filesystem::exists(path)) return {path, std::move(columns)};
    std::filesystem::resize_file(path, history_size_until(path, columns, time));
    return {path, std::move(columns), std::ios::app};
}

void History::add(double time, std::span<const double> values)
{
    if (values.size() != columns_.size())
        throw Error(fmt::format("a history of {} columns was given {} values", columns_.size(), values.size()));
    std::string line = fmt::format("{}", time);
    for (const double value : values) {
        line += ',';
        if (!std::isnan(value)) fmt::format_to(std::back_inserter(line), "{}", value);
    }
    stream_ << line << '\n' << std::flush;
    if (!stream_) throw Error(fmt::format("cannot write '{}'", path_.string()), "is the disk full?");
}

}  // namespace corpuscle
