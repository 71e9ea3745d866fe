#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// Scalar type of a field's values in files.
enum class Scalar { float32, float64, uint8, int32, uint32, uint64 };

[[nodiscard]] std::size_t size_of(Scalar scalar);

/// A named quantity on each thing of a set, described by itself: enough to print it, draw it, save it and bring it back.
struct Field {
    std::string name;     ///< snake_case, as in files
    std::string unit;     ///< SI, "1" if none
    std::string meaning;  ///< one line for the manual
    Scalar scalar = Scalar::float32;
    int components = 1;
    std::size_t count = 0;                                               ///< things
    std::function<void(void* values)> gather;                            ///< writes count * components scalars
    std::function<void(const void* values, std::size_t count)> restore;  ///< takes them back (and resizes); empty if derived
};

/// The fields on one set of things.
struct FieldSet {
    std::string name;  ///< of the set: "gas", "structure nodes", ...
    std::vector<Field> fields;

    [[nodiscard]] const Field* find(const std::string& field_name) const;
};

namespace detail {

template <class T>
struct ScalarOf {
    static constexpr int components = 1;
    static constexpr Scalar scalar = std::is_same_v<T, float>           ? Scalar::float32
                                     : std::is_same_v<T, double>        ? Scalar::float64
                                     : std::is_same_v<T, std::uint8_t>  ? Scalar::uint8
                                     : std::is_same_v<T, std::int32_t>  ? Scalar::int32
                                     : std::is_same_v<T, std::uint32_t> ? Scalar::uint32
                                                                        : Scalar::uint64;
};

template <class T>
struct ScalarOf<Vector3<T>> {
    static constexpr int components = 3;
    static constexpr Scalar scalar = ScalarOf<T>::scalar;
};

}  // namespace detail

/// A field that is an array: saved and brought back as it is.
template <class T>
Field stored_field(std::string name, std::string unit, std::string meaning, std::vector<T>& values)
{
    Field field{std::move(name),
                std::move(unit),
                std::move(meaning),
                detail::ScalarOf<T>::scalar,
                detail::ScalarOf<T>::components,
                values.size(),
                {},
                {}};
    field.gather = [&values](void* out) { std::copy(values.begin(), values.end(), static_cast<T*>(out)); };
    field.restore = [&values](const void* in, std::size_t count) {
        const T* first = static_cast<const T*>(in);
        values.assign(first, first + count);
    };
    return field;
}

/// A field that is computed when asked for: value(i), i in [0, count).
template <class T, class Value>
Field derived_field(std::string name, std::string unit, std::string meaning, std::size_t count, Value value)
{
    Field field{
        std::move(name), std::move(unit), std::move(meaning), detail::ScalarOf<T>::scalar, detail::ScalarOf<T>::components, count, {}, {}};
    field.gather = [count, value = std::move(value)](void* out) {
        T* first = static_cast<T*>(out);
        for (std::size_t i = 0; i < count; ++i) first[i] = value(i);
    };
    return field;
}

}  // namespace corpuscle
