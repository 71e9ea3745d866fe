#include "output/hdf5.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::uint64_t chunk_bytes = std::uint64_t{1} << 20U;

/// What the system says went wrong, out of a long message of the library; the whole message where the system says nothing.
std::string system_message(const std::string& message)
{
    const std::string mark = "error message = '";
    const std::size_t begin = message.find(mark);
    if (begin == std::string::npos) return message;
    const std::size_t from = begin + mark.size();
    return message.substr(from, message.find('\'', from) - from);
}

/// Keeps the innermost message of the library's error stack.
herr_t keep_first(unsigned, const H5E_error2_t* entry, void* text)
{
    auto& kept = *static_cast<std::string*>(text);
    if (kept.empty() && entry->desc != nullptr) kept = system_message(entry->desc);
    return 0;
}

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path)
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
    H5Eclear2(H5E_DEFAULT);
    throw Error(fmt::format("cannot {} in '{}'{}{}", what, path.string(), reason.empty() ? "" : ": ", reason),
                "check that the file is whole, the folder writable and the disk not full");
}

/// An identifier of the library that is given back at the end of its scope.
class Handle {
public:
    Handle(hid_t id, herr_t (*give_back)(hid_t)) : id_(id), give_back_(give_back) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle()
    {
        if (id_ >= 0) give_back_(id_);
    }
    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] bool good() const { return id_ >= 0; }

private:
    hid_t id_;
    herr_t (*give_back_)(hid_t);
};

/// The type of values in memory.
hid_t memory_type(Hdf5Type type)
{
    switch (type) {
        case Hdf5Type::float32: return H5T_NATIVE_FLOAT;
        case Hdf5Type::float64: return H5T_NATIVE_DOUBLE;
        case Hdf5Type::uint8: return H5T_NATIVE_UINT8;
        case Hdf5Type::int32: return H5T_NATIVE_INT32;
        case Hdf5Type::uint32: return H5T_NATIVE_UINT32;
        case Hdf5Type::int64: return H5T_NATIVE_INT64;
        case Hdf5Type::uint64: break;
    }
    return H5T_NATIVE_UINT64;
}

/// The type of a stored data set; anything the program never writes is refused.
Hdf5Type stored_type(hid_t type, const std::string& name, const std::filesystem::path& path)
{
    const std::size_t size = H5Tget_size(type);
    const H5T_class_t kind = H5Tget_class(type);
    if (kind == H5T_FLOAT && size == 4) return Hdf5Type::float32;
    if (kind == H5T_FLOAT && size == 8) return Hdf5Type::float64;
    const bool is_signed = kind == H5T_INTEGER && H5Tget_sign(type) == H5T_SGN_2;
    if (kind == H5T_INTEGER && size == 1 && !is_signed) return Hdf5Type::uint8;
    if (kind == H5T_INTEGER && size == 4) return is_signed ? Hdf5Type::int32 : Hdf5Type::uint32;
    if (kind == H5T_INTEGER && size == 8) return is_signed ? Hdf5Type::int64 : Hdf5Type::uint64;
    throw Error(fmt::format("'{}' in '{}' has a type that is never written here", name, path.string()), "is it a file of this program?");
}

/// No messages on the terminal; no locks, since files are read only when finished (some network file systems cannot lock); no work of the
/// library's own at the program's end, where it would close once more a file that a full disk kept it from closing, and crash.
Handle access_properties()
{
    [[maybe_unused]] static const herr_t left_alone = H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const hid_t properties = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_file_locking(properties, 0, 1);
    return {properties, H5Pclose};
}

/// Chunks of whole planes of the slowest extent, about 1 MiB each; a data set without values or of few stays contiguous.
bool set_chunks(hid_t properties, const Hdf5Shape& shape, int gzip)
{
    const std::uint64_t count = shape.value_count();
    if (count == 0) return true;
    std::vector<hsize_t> chunk(shape.extents.begin(), shape.extents.end());
    std::uint64_t bytes = count * size_of(shape.type);
    for (std::size_t axis = 0; axis < chunk.size() && bytes > chunk_bytes; ++axis) {
        const std::uint64_t plane = bytes / chunk[axis];
        chunk[axis] = std::clamp<std::uint64_t>(chunk_bytes / plane, 1, chunk[axis]);
        bytes = plane * chunk[axis];
    }
    bool good = H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) >= 0;
    if (gzip > 0) good = good && H5Pset_shuffle(properties) >= 0 && H5Pset_deflate(properties, static_cast<unsigned>(gzip)) >= 0;
    return good;
}

/// Opens an object and lets `write` attach something to it.
void attach(hid_t file, const std::string& object, const std::string& name, const std::function<bool(hid_t)>& write)
{
    const Handle target(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose);
    if (!target.good() || !write(target.id()))
        throw Error(fmt::format("cannot write attribute '{}' of '{}'", name, object), "is the disk full?");
}

bool attach_array(hid_t object, const std::string& name, hid_t type, std::size_t count, const void* values)
{
    const hsize_t extent = count;
    const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute.good() && H5Awrite(attribute.id(), type, values) >= 0;
}

bool attach_text(hid_t object, const std::string& name, const std::string& value)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), std::max<std::size_t>(value.size(), 1));
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    const bool ascii = std::all_of(value.begin(), value.end(), [](char letter) { return static_cast<unsigned char>(letter) < 128; });
    H5Tset_cset(type.id(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(object, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const std::string padded = value.empty() ? std::string(1, '\0') : value;
    return attribute.good() && H5Awrite(attribute.id(), type.id(), padded.data()) >= 0;
}

/// Reads a whole attribute of numbers; nothing if there is none.
template <class T>
std::vector<T> read_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type)
{
    const Handle attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.good()) return {};
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    if (H5Aread(attribute.id(), type, values.data()) < 0) values.clear();
    return values;
}

}  // namespace

Hdf5Type hdf5_type(Scalar scalar)
{
    switch (scalar) {
        case Scalar::float32: return Hdf5Type::float32;
        case Scalar::float64: return Hdf5Type::float64;
        case Scalar::uint8: return Hdf5Type::uint8;
        case Scalar::int32: return Hdf5Type::int32;
        case Scalar::uint32: return Hdf5Type::uint32;
        case Scalar::uint64: break;
    }
    return Hdf5Type::uint64;
}

std::size_t size_of(Hdf5Type type)
{
    switch (type) {
        case Hdf5Type::uint8: return 1;
        case Hdf5Type::float32:
        case Hdf5Type::int32:
        case Hdf5Type::uint32: return 4;
        case Hdf5Type::float64:
        case Hdf5Type::int64:
        case Hdf5Type::uint64: break;
    }
    return 8;
}

std::uint64_t Hdf5Shape::value_count() const
{
    return std::accumulate(extents.begin(), extents.end(), std::uint64_t{1}, std::multiplies<>());
}

Hdf5Shape shape_of(const Field& field)
{
    Hdf5Shape shape{hdf5_type(field.scalar), {field.count}};
    if (field.components > 1) shape.extents.push_back(static_cast<std::uint64_t>(field.components));
    return shape;
}

Hdf5File::Hdf5File(std::int64_t id, std::filesystem::path path) : id_(id), path_(std::move(path)) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept : id_(std::exchange(other.id_, -1)), path_(std::move(other.path_)) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(path_, other.path_);
    return *this;
}

Hdf5File::~Hdf5File()
{
    if (id_ >= 0) H5Fclose(id_);
}

Hdf5File Hdf5File::create(const std::filesystem::path& path)
{
    const Handle access = access_properties();
    const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
    if (id < 0) fail("create the file", path);
    return {id, path};
}

Hdf5File Hdf5File::open(const std::filesystem::path& path)
{
    const Handle access = access_properties();
    const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
    if (id < 0) fail("open the file", path);
    return {id, path};
}

void Hdf5File::close()
{
    const hid_t id = std::exchange(id_, -1);
    if (id >= 0 && H5Fclose(id) < 0) fail("finish what was written", path_);
}

void Hdf5File::add_group(const std::string& group)
{
    const Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(properties.id(), 1);
    const Handle made(H5Gcreate2(id_, group.c_str(), properties.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    if (!made.good()) fail(fmt::format("make group '{}'", group), path_);
}

void Hdf5File::write(const std::string& name, const Hdf5Shape& shape, const void* values, int gzip)
{
    const std::vector<hsize_t> extents(shape.extents.begin(), shape.extents.end());
    const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties.id(), false);
    const bool planned = set_chunks(properties.id(), shape, gzip);
    const hid_t type = memory_type(shape.type);
    const Handle data(H5Dcreate2(id_, name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose);
    if (!planned || !data.good()) fail(fmt::format("make '{}'", name), path_);
    if (shape.value_count() > 0 && H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(fmt::format("write '{}'", name), path_);
}

void Hdf5File::write(const std::string& name, const Field& field, const Hdf5Shape& shape, int gzip)
{
    std::vector<std::byte> values(shape.value_count() * size_of(shape.type));
    field.gather(values.data());
    write(name, shape, values.data(), gzip);
    set_attribute(name, "unit", field.unit);
    set_attribute(name, "meaning", field.meaning);
}

void Hdf5File::write(const std::string& name, const std::vector<std::int64_t>& values, int gzip)
{
    write(name, {Hdf5Type::int64, {values.size()}}, values.data(), gzip);
}

void Hdf5File::write(const std::string& name, const std::vector<double>& values, int gzip)
{
    write(name, {Hdf5Type::float64, {values.size()}}, values.data(), gzip);
}

void Hdf5File::write(const std::string& name, const std::vector<std::uint8_t>& values, int gzip)
{
    write(name, {Hdf5Type::uint8, {values.size()}}, values.data(), gzip);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value)
{
    attach(id_, object, name, [&](hid_t target) { return attach_text(target, name, value); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values)
{
    attach(id_, object, name, [&](hid_t target) { return attach_array(target, name, H5T_NATIVE_INT64, values.size(), values.data()); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::vector<double>& values)
{
    attach(id_, object, name, [&](hid_t target) { return attach_array(target, name, H5T_NATIVE_DOUBLE, values.size(), values.data()); });
}

bool Hdf5File::has(const std::string& name) const
{
    // Every group on the way must exist before the library may be asked for the last name.
    for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
        if (H5Lexists(id_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string::npos) return true;
    }
}

std::vector<std::string> Hdf5File::members(const std::string& group) const
{
    const Handle opened(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose);
    if (!opened.good()) fail(fmt::format("open group '{}'", group), path_);
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->emplace_back(name);
        return 0;
    };
    H5Literate(opened.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
    return names;
}

Hdf5Shape Hdf5File::shape(const std::string& name) const
{
    const Handle data(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data.good()) fail(fmt::format("open '{}'", name), path_);
    const Handle space(H5Dget_space(data.id()), H5Sclose);
    const Handle type(H5Dget_type(data.id()), H5Tclose);
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space.id()), 0)));
    H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
    return {stored_type(type.id(), name, path_), {extents.begin(), extents.end()}};
}

void Hdf5File::read(const std::string& name, Hdf5Type type, void* values) const
{
    if (shape(name).value_count() == 0) return;
    const Handle data(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data.good() || H5Dread(data.id(), memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(fmt::format("read '{}'", name), path_);
}

std::vector<std::int64_t> Hdf5File::read_integers(const std::string& name) const
{
    std::vector<std::int64_t> values(shape(name).value_count());
    read(name, Hdf5Type::int64, values.data());
    return values;
}

std::vector<double> Hdf5File::read_numbers(const std::string& name) const
{
    std::vector<double> values(shape(name).value_count());
    read(name, Hdf5Type::float64, values.data());
    return values;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const
{
    const Handle attribute(H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.good()) fail(fmt::format("open attribute '{}' of '{}'", name, object), path_);
    const Handle type(H5Aget_type(attribute.id()), H5Tclose);
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0) {
        throw Error(fmt::format("attribute '{}' of '{}' in '{}' is not a text of fixed length", name, object, path_.string()));
    }
    std::string value(H5Tget_size(type.id()), '\0');
    if (H5Aread(attribute.id(), type.id(), value.data()) < 0) fail(fmt::format("read attribute '{}' of '{}'", name, object), path_);
    value.erase(std::find(value.begin(), value.end(), '\0'), value.end());
    return value;
}

std::vector<std::int64_t> Hdf5File::integer_attribute(const std::string& object, const std::string& name) const
{
    auto values = read_attribute<std::int64_t>(id_, object, name, H5T_NATIVE_INT64);
    if (values.empty()) fail(fmt::format("read attribute '{}' of '{}'", name, object), path_);
    return values;
}

std::vector<double> Hdf5File::number_attribute(const std::string& object, const std::string& name) const
{
    auto values = read_attribute<double>(id_, object, name, H5T_NATIVE_DOUBLE);
    if (values.empty()) fail(fmt::format("read attribute '{}' of '{}'", name, object), path_);
    return values;
}

}  // namespace corpuscle
