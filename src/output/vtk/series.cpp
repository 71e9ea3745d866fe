#include "output/vtk/series.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "output/vtk/vtk_file.hpp"

namespace corpuscle {

namespace {

/// The entries of a list file of ParaView.
std::vector<VtkSeries::Entry> read_list(const std::filesystem::path& path)
{
    try {
        const nlohmann::json list = nlohmann::json::parse(read_file(path));
        std::vector<VtkSeries::Entry> entries;
        for (const auto& file : list.at("files")) {
            entries.push_back({file.at("name").get<std::string>(), file.at("time").get<double>()});
        }
        return entries;
    } catch (const nlohmann::json::exception& problem) {
        throw Error(fmt::format("cannot understand '{}': {}", path.string(), problem.what()), "remove it, the family then starts anew");
    }
}

}  // namespace

VtkSeries::VtkSeries(std::filesystem::path folder, const std::string& family) : folder_(std::move(folder)), family_(vtk_name(family)) {}

std::filesystem::path VtkSeries::list() const
{
    return folder_ / (family_ + ".hdf.series");
}

void VtkSeries::resume(double time)
{
    entries_.clear();
    if (!std::filesystem::exists(list())) return;
    std::vector<Entry> dropped;
    for (Entry& entry : read_list(list())) (entry.time <= time ? entries_ : dropped).push_back(std::move(entry));
    write_list();
    for (const Entry& entry : dropped) std::filesystem::remove(folder_ / entry.name);
}

void VtkSeries::add(double time, const std::function<void(const std::filesystem::path&)>& write)
{
    const std::string name = fmt::format("{}_{:06}.hdf", family_, entries_.size());
    write(aside(folder_ / name));
    finish_aside(folder_ / name, Durability::system);
    entries_.push_back({name, time});
    write_list();
}

void VtkSeries::write_list() const
{
    nlohmann::json files = nlohmann::json::array();
    for (const Entry& entry : entries_) files.push_back({{"name", entry.name}, {"time", entry.time}});
    replace_file(list(), nlohmann::json{{"file-series-version", "1.0"}, {"files", files}}.dump(1) + "\n");
}

}  // namespace corpuscle
