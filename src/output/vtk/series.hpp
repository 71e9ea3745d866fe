#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace corpuscle {

/// One family of files for ParaView ("gas": gas_000000.hdf, ...) and the gas.hdf.series that makes them an animation. Each file is written
/// aside and renamed, then the list, so ParaView may look on while the run goes on and a kill leaves both whole.
class VtkSeries {
public:
    struct Entry {
        std::string name;  ///< of the file, in the same folder
        double time = 0;   ///< [s]
    };

    /// A new family in an existing folder.
    VtkSeries(std::filesystem::path folder, const std::string& family);

    /// Takes up the family's list as it stands on the disk: entries after `time` [s] (of steps that will be done again) are dropped and
    /// their files removed. A family that has no list yet starts anew. Throws Error if the list cannot be understood.
    void resume(double time);

    /// Lets `write` write the file of `time` [s] under the name it is given, then adds it to the list.
    void add(double time, const std::function<void(const std::filesystem::path&)>& write);

    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    /// The file to open in ParaView.
    [[nodiscard]] std::filesystem::path list() const;

private:
    void write_list() const;

    std::filesystem::path folder_;
    std::string family_;
    std::vector<Entry> entries_;
};

}  // namespace corpuscle
