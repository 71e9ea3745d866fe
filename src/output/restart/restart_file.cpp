#include "output/restart/restart_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "output/restart/seal.hpp"

namespace corpuscle {

namespace {

constexpr std::int64_t format_version = 1;

/// A name as a link of HDF5, where '/' separates groups and "." is the group itself.
std::string link_name(std::string name)
{
    std::replace(name.begin(), name.end(), '/', '|');
    if (name == ".") name = "_";
    return name;
}

std::string value_path(const std::string& name)
{
    return "/values/" + link_name(name);
}

std::string set_path(const FieldSet& set)
{
    return "/fields/" + link_name(set.name);
}

std::string field_path(const FieldSet& set, const Field& field)
{
    return set_path(set) + "/" + link_name(field.name);
}

bool saved(const Field& field)
{
    return static_cast<bool>(field.restore);
}

/// Two things of one name could not be told apart when read back.
void refuse_twins(const std::vector<FieldSet>& sets)
{
    std::set<std::string> seen;
    for (const FieldSet& set : sets) {
        if (!seen.insert(set_path(set)).second) throw Error(fmt::format("two sets of fields are named '{}'", set.name));
        for (const Field& field : set.fields) {
            if (saved(field) && !seen.insert(field_path(set, field)).second) {
                throw Error(fmt::format("two fields of '{}' are named '{}'", set.name, field.name));
            }
        }
    }
}

/// Writes one single value; its type in the file tells its type here.
struct ValueWriter {
    Hdf5File& file;
    std::string path;

    void operator()(double value) const { file.write(path, std::vector<double>{value}); }
    void operator()(std::uint64_t value) const { file.write(path, {Hdf5Type::uint64, {1}}, &value); }
    void operator()(const std::string& value) const { file.write(path, {Hdf5Type::uint8, {value.size()}}, value.data()); }
};

RestartValue read_value(const Hdf5File& file, const std::string& path)
{
    const Hdf5Shape shape = file.shape(path);
    if (shape.type == Hdf5Type::float64) return file.read_numbers(path).at(0);
    if (shape.type == Hdf5Type::uint64) {
        std::uint64_t value = 0;
        if (shape.value_count() == 1) file.read(path, shape.type, &value);
        return value;
    }
    std::string text(shape.value_count(), '\0');
    file.read(path, Hdf5Type::uint8, text.data());
    return text;
}

Hdf5File open_checked(const std::filesystem::path& path)
{
    check_seal(path);
    return Hdf5File::open(path);
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what)
{
    throw InputError(fmt::format("the saved state '{}' does not fit the case: {}", path.string(), what),
                     "resume with the case and the program version that saved it");
}

}  // namespace

void write_restart(const std::filesystem::path& path, const RestartContent& content)
{
    refuse_twins(content.sets);
    const std::filesystem::path part = aside(path);
    Hdf5File file = Hdf5File::create(part);
    file.set_attribute("/", "corpuscle_restart", std::vector<std::int64_t>{format_version});
    file.add_group("/values");
    for (const auto& [name, value] : content.values) std::visit(ValueWriter{file, value_path(name)}, value);
    file.add_group("/fields");
    for (const FieldSet& set : content.sets) {
        file.add_group(set_path(set));
        for (const Field& field : set.fields) {
            if (saved(field)) file.write(field_path(set, field), field, shape_of(field), 0);
        }
    }
    file.close();
    seal_file(part);
    finish_aside(path, Durability::disk);
}

RestartFile::RestartFile(const std::filesystem::path& path) : path_(path), file_(open_checked(path))
{
    const std::int64_t version = file_.integer_attribute("/", "corpuscle_restart").front();
    if (version != format_version)
        refuse(path_, fmt::format("its format is version {}, this program reads version {}", version, format_version));
    read_values();
}

void RestartFile::read_values()
{
    for (const std::string& name : file_.members("/values")) values_[name] = read_value(file_, "/values/" + name);
}

const RestartValue& RestartFile::value(const std::string& name) const
{
    const auto found = values_.find(link_name(name));
    if (found == values_.end()) refuse(path_, fmt::format("it has no value '{}'", name));
    return found->second;
}

double RestartFile::number(const std::string& name) const
{
    const auto* result = std::get_if<double>(&value(name));
    if (result == nullptr) refuse(path_, fmt::format("its value '{}' is not a number", name));
    return *result;
}

std::uint64_t RestartFile::count(const std::string& name) const
{
    const auto* result = std::get_if<std::uint64_t>(&value(name));
    if (result == nullptr) refuse(path_, fmt::format("its value '{}' is not a count", name));
    return *result;
}

const std::string& RestartFile::text(const std::string& name) const
{
    const auto* result = std::get_if<std::string>(&value(name));
    if (result == nullptr) refuse(path_, fmt::format("its value '{}' is not a text", name));
    return *result;
}

void RestartFile::compare(const std::vector<FieldSet>& sets) const
{
    std::set<std::string> expected;
    for (const FieldSet& set : sets) {
        if (!file_.has(set_path(set))) refuse(path_, fmt::format("it has no '{}'", set.name));
        expected.insert(set_path(set));
        for (const Field& field : set.fields) {
            if (!saved(field)) continue;
            const std::string path = field_path(set, field);
            expected.insert(path);
            if (!file_.has(path)) refuse(path_, fmt::format("'{}' has no field '{}'", set.name, field.name));
            const Hdf5Shape stored = file_.shape(path);
            const std::size_t components = stored.extents.size() > 1 ? stored.extents[1] : 1;
            if (stored.type != hdf5_type(field.scalar) || components != static_cast<std::size_t>(field.components) ||
                stored.extents.empty()) {
                refuse(path_, fmt::format("field '{}' of '{}' is of another type", field.name, set.name));
            }
        }
    }
    for (const std::string& set : file_.members("/fields")) {
        if (!expected.contains("/fields/" + set)) refuse(path_, fmt::format("the case has no '{}'", set));
        for (const std::string& field : file_.members("/fields/" + set)) {
            if (!expected.contains("/fields/" + set + "/" + field))
                refuse(path_, fmt::format("'{}' of the case has no field '{}'", set, field));
        }
    }
}

void RestartFile::restore(const std::vector<FieldSet>& sets) const
{
    refuse_twins(sets);
    compare(sets);
    std::vector<std::byte> values;
    for (const FieldSet& set : sets) {
        for (const Field& field : set.fields) {
            if (!saved(field)) continue;
            const std::string path = field_path(set, field);
            const Hdf5Shape shape = file_.shape(path);
            values.resize(shape.value_count() * size_of(shape.type));
            file_.read(path, shape.type, values.data());
            field.restore(values.data(), shape.extents.front());
        }
    }
}

}  // namespace corpuscle
