#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "fields/field.hpp"
#include "output/hdf5.hpp"

namespace corpuscle {

/// Single values of a saved state, by name: the time, the step, the random seed, ...
using RestartValue = std::variant<double, std::uint64_t, std::string>;
using RestartValues = std::map<std::string, RestartValue>;

/// Everything a run goes on from. Only fields that can be restored are saved.
struct RestartContent {
    RestartValues values;
    std::vector<FieldSet> sets;
};

/// Writes a state aside, closes it with a checksum over every byte, waits for the disk and gives it its name: the file is whole or not
/// there. Throws Error (a full disk, two sets or fields of one name).
void write_restart(const std::filesystem::path& path, const RestartContent& content);

/// A saved state, read back.
class RestartFile {
public:
    /// Opens a state and proves its checksum. Throws Error if the file is torn, damaged, or of another version.
    explicit RestartFile(const std::filesystem::path& path);

    [[nodiscard]] const RestartValues& values() const { return values_; }
    /// The value of one name. Throws Error if it is missing or of another type.
    [[nodiscard]] double number(const std::string& name) const;
    [[nodiscard]] std::uint64_t count(const std::string& name) const;
    [[nodiscard]] const std::string& text(const std::string& name) const;

    /// Gives every field of `sets` its saved values. The saved names, types and components must be exactly those of `sets`: all is
    /// compared before the first value is changed, and what differs is named in the Error.
    void restore(const std::vector<FieldSet>& sets) const;

private:
    [[nodiscard]] const RestartValue& value(const std::string& name) const;
    void read_values();
    void compare(const std::vector<FieldSet>& sets) const;

    std::filesystem::path path_;
    Hdf5File file_;
    RestartValues values_;
};

}  // namespace corpuscle
