#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "fields/field.hpp"

namespace corpuscle {

/// Types of the values in an HDF5 data set, little-endian in the file.
enum class Hdf5Type { float32, float64, uint8, int32, uint32, int64, uint64 };

[[nodiscard]] Hdf5Type hdf5_type(Scalar scalar);
[[nodiscard]] std::size_t size_of(Hdf5Type type);

/// Type and extents of a data set, slowest extent first.
struct Hdf5Shape {
    Hdf5Type type = Hdf5Type::float64;
    std::vector<std::uint64_t> extents;

    [[nodiscard]] std::uint64_t value_count() const;
    friend bool operator==(const Hdf5Shape&, const Hdf5Shape&) = default;
};

/// The shape a field has in a file: [count] or [count][components].
[[nodiscard]] Hdf5Shape shape_of(const Field& field);

/// An HDF5 file: groups, data sets and attributes by path ("/VTKHDF/Points"). Every failure of the library is an Error that names the file;
/// nothing is printed.
class Hdf5File {
public:
    /// A new file, replacing an older one.
    [[nodiscard]] static Hdf5File create(const std::filesystem::path& path);
    /// An existing file, read only.
    [[nodiscard]] static Hdf5File open(const std::filesystem::path& path);

    Hdf5File(Hdf5File&& other) noexcept;
    Hdf5File& operator=(Hdf5File&& other) noexcept;
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;
    ~Hdf5File();

    /// Writes what is pending and closes; the destructor does it too, but cannot report a full disk.
    void close();

    /// Makes a group and the groups above it.
    void add_group(const std::string& group);
    /// Writes a data set in chunks of about 1 MiB; gzip 1..9 compresses them (with byte shuffle), 0 leaves them as they are.
    void write(const std::string& name, const Hdf5Shape& shape, const void* values, int gzip = 0);
    /// Writes a field's values as a data set, with its unit and meaning as attributes.
    void write(const std::string& name, const Field& field, const Hdf5Shape& shape, int gzip);
    void write(const std::string& name, const std::vector<std::int64_t>& values, int gzip = 0);
    void write(const std::string& name, const std::vector<double>& values, int gzip = 0);
    void write(const std::string& name, const std::vector<std::uint8_t>& values, int gzip = 0);

    void set_attribute(const std::string& object, const std::string& name, const std::string& value);
    void set_attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values);
    void set_attribute(const std::string& object, const std::string& name, const std::vector<double>& values);

    [[nodiscard]] bool has(const std::string& name) const;
    /// Names of what lies in a group, in alphabetical order.
    [[nodiscard]] std::vector<std::string> members(const std::string& group) const;
    [[nodiscard]] Hdf5Shape shape(const std::string& name) const;
    /// Reads a whole data set, converted to `type`, into memory for shape(name).value_count() values.
    void read(const std::string& name, Hdf5Type type, void* values) const;
    [[nodiscard]] std::vector<std::int64_t> read_integers(const std::string& name) const;
    [[nodiscard]] std::vector<double> read_numbers(const std::string& name) const;

    [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] std::vector<std::int64_t> integer_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] std::vector<double> number_attribute(const std::string& object, const std::string& name) const;

private:
    Hdf5File(std::int64_t id, std::filesystem::path path);

    std::int64_t id_;
    std::filesystem::path path_;
};

}  // namespace corpuscle
