#include "fields/field.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

/// What gather() writes, as bytes.
std::vector<std::byte> gathered(const Field& field)
{
    std::vector<std::byte> bytes(field.count * field.components * size_of(field.scalar));
    field.gather(bytes.data());
    return bytes;
}

/// Saves an array through its field and brings it back into another: the same values, whatever was there.
template <class T>
void expect_round_trip(std::vector<T> values, Scalar scalar, int components)
{
    const Field from = stored_field("values", "m", "test", values);
    EXPECT_EQ(from.scalar, scalar);
    EXPECT_EQ(from.components, components);
    EXPECT_EQ(from.count, values.size());
    std::vector<T> other(3);
    const Field to = stored_field("values", "m", "test", other);
    const std::vector<std::byte> bytes = gathered(from);
    EXPECT_EQ(bytes.size(), values.size() * sizeof(T));
    to.restore(bytes.data(), from.count);
    EXPECT_EQ(other, values);
}

TEST(Field, StoredFieldsComeBackAsTheyWere)
{
    expect_round_trip<float>({1.5f, -2.25f}, Scalar::float32, 1);
    expect_round_trip<double>({0.1, 1e300, -0.0, 4.0, 5.0}, Scalar::float64, 1);
    expect_round_trip<std::uint8_t>({0, 255}, Scalar::uint8, 1);
    expect_round_trip<std::int32_t>({-7, 2'000'000'000}, Scalar::int32, 1);
    expect_round_trip<std::uint32_t>({4'000'000'000u}, Scalar::uint32, 1);
    expect_round_trip<std::uint64_t>({std::uint64_t{1} << 63, 2}, Scalar::uint64, 1);
    expect_round_trip<Vector3d>({{1, 2, 3}, {0.1, -0.2, 1e-300}}, Scalar::float64, 3);
    expect_round_trip<Vector3f>({{1, 2, 3}}, Scalar::float32, 3);
    expect_round_trip<double>({}, Scalar::float64, 1);
}

TEST(Field, StoredFieldsFollowTheirArray)
{
    std::vector<double> values{1, 2};
    const Field field = stored_field("values", "Pa", "what they mean", values);
    values[1] = 7;
    double out[2];
    field.gather(out);
    EXPECT_EQ(out[1], 7.0);
    EXPECT_EQ(field.name, "values");
    EXPECT_EQ(field.unit, "Pa");
    EXPECT_EQ(field.meaning, "what they mean");
}

TEST(Field, DerivedFieldsAreComputedWhenAskedFor)
{
    double factor = 1;
    const Field field = derived_field<Vector3f>("twice", "1", "", 2,
                                                [&](std::size_t i) { return Vector3f(Vector3d(factor * static_cast<double>(i), 1, 2)); });
    factor = 10;
    Vector3f out[2];
    field.gather(out);
    EXPECT_EQ(out[0], Vector3f(0, 1, 2));
    EXPECT_EQ(out[1], Vector3f(10, 1, 2));
    EXPECT_EQ(field.components, 3);
    EXPECT_EQ(field.scalar, Scalar::float32);
    EXPECT_FALSE(field.restore);  // nothing to bring back
}

TEST(Field, SizesAreThoseOfTheScalars)
{
    EXPECT_EQ(size_of(Scalar::uint8), sizeof(std::uint8_t));
    EXPECT_EQ(size_of(Scalar::float32), sizeof(float));
    EXPECT_EQ(size_of(Scalar::int32), sizeof(std::int32_t));
    EXPECT_EQ(size_of(Scalar::uint32), sizeof(std::uint32_t));
    EXPECT_EQ(size_of(Scalar::float64), sizeof(double));
    EXPECT_EQ(size_of(Scalar::uint64), sizeof(std::uint64_t));
}

TEST(FieldSet, FindsByName)
{
    std::vector<double> values{1};
    const FieldSet set{"nodes", {stored_field("mass", "kg", "", values), stored_field("inertia", "kg m2", "", values)}};
    ASSERT_NE(set.find("inertia"), nullptr);
    EXPECT_EQ(set.find("inertia")->unit, "kg m2");
    EXPECT_EQ(set.find("charge"), nullptr);
}

}  // namespace
}  // namespace corpuscle
