#include "math/single.hpp"

#include <gtest/gtest.h>

#include "math/random.hpp"

namespace corpuscle {
namespace {

TEST(Single, is_what_a_float_keeps)
{
    Random random(1, Purpose::contact, 0, 0);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::ldexp(2 * random.uniform_double() - 1, static_cast<int>(random.below(200)) - 100);
        volatile float stored = static_cast<float>(x);
        EXPECT_EQ(single(x), static_cast<double>(stored));
    }
    EXPECT_EQ(single(0.0), 0.0);
    EXPECT_EQ(single(1 + 0x1p-24), 1.0);
    EXPECT_EQ(single(1 + 3 * 0x1p-24), 1 + 0x1p-22);
    EXPECT_EQ(single(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(single(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Single, rounds_all_components_of_a_vector)
{
    const Vector3d v = single(Vector3d{0.1, 0.2, 0.3});
    EXPECT_EQ(v, Vector3d(0x1.99999ap-4, 0x1.99999ap-3, 0x1.333334p-2));
}

}  // namespace
}  // namespace corpuscle
