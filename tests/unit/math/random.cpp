#include "math/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace corpuscle {
namespace {

// Bounds are four standard deviations of the statistic for independent variates of the exact law; streams are fixed, so a
// test passes always or never.
constexpr int samples = 400'000;

/// Sample moments about a given mean.
struct Moments {
    double mean = 0, second = 0, third = 0, fourth = 0;
};

template <class Draw>
Moments moments_about(double center, const Draw& draw)
{
    Moments m;
    for (int i = 0; i < samples; ++i) {
        const double d = static_cast<double>(draw()) - center;
        m.mean += d;
        m.second += d * d;
        m.third += d * d * d;
        m.fourth += d * d * d * d;
    }
    return {center + m.mean / samples, m.second / samples, m.third / samples, m.fourth / samples};
}

/// Four standard deviations of the mean of `samples` variates of this variance.
double bound(double variance)
{
    return 4.0 * std::sqrt(variance / samples);
}

/// One stream for each call, as the gas uses them: a few draws each.
class ManyStreams {
public:
    explicit ManyStreams(std::uint64_t seed) : seed_(seed) {}
    Random& next()
    {
        if (++draws_ % 8 == 0) stream_ = Random(seed_, Purpose::collide, 3, ++index_);
        return stream_;
    }

private:
    std::uint64_t seed_;
    std::uint64_t index_ = 0;
    int draws_ = 0;
    Random stream_{seed_, Purpose::collide, 3, 0};
};

TEST(Random, NeverReachesZeroOrOne)
{
    EXPECT_GT(unit_float(0), 0.0f);
    EXPECT_LT(unit_float(0xffffffff), 1.0f);
    EXPECT_EQ(unit_float(0), 1.0f - unit_float(0xffffffff));
    EXPECT_GT(unit_double(0, 0), 0.0);
    EXPECT_LT(unit_double(0xffffffff, 0xffffffff), 1.0);
    EXPECT_EQ(unit_double(0, 0), 1.0 - unit_double(0xffffffff, 0xffffffff));
}

TEST(Random, UniformHasTheMomentsOfItsLaw)
{
    ManyStreams streams(7);
    const auto check = [](const Moments& m) {
        EXPECT_NEAR(m.mean, 0.5, bound(1.0 / 12));
        EXPECT_NEAR(m.second, 1.0 / 12, bound(1.0 / 80 - 1.0 / 144));
        EXPECT_NEAR(m.third, 0.0, bound(1.0 / 448));
        EXPECT_NEAR(m.fourth, 1.0 / 80, bound(1.0 / 2304 - 1.0 / 6400));
    };
    check(moments_about(0.5, [&] { return streams.next().uniform(); }));
    check(moments_about(0.5, [&] { return streams.next().uniform_double(); }));
}

TEST(Random, UniformFillsEveryBinAlike)
{
    constexpr int bins = 256;
    std::vector<int> count(bins);
    ManyStreams streams(8);
    for (int i = 0; i < samples; ++i) ++count[static_cast<int>(streams.next().uniform() * bins)];
    double chi_squared = 0;
    const double expected = static_cast<double>(samples) / bins;
    for (const int c : count) chi_squared += (c - expected) * (c - expected) / expected;
    EXPECT_NEAR(chi_squared, bins - 1.0, 4.0 * std::sqrt(2.0 * (bins - 1)));
}

TEST(Random, BelowFillsItsRangeAlike)
{
    constexpr std::uint32_t n = 7;
    std::vector<int> count(n);
    ManyStreams streams(9);
    for (int i = 0; i < samples; ++i) {
        const std::uint32_t k = streams.next().below(n);
        ASSERT_LT(k, n);
        ++count[k];
    }
    for (const int c : count) EXPECT_NEAR(c, samples / 7.0, 4.0 * std::sqrt(samples * (1.0 / 7) * (6.0 / 7)));
    EXPECT_EQ(Random(1, Purpose::fill, 0, 0).below(1), 0u);
}

TEST(Random, NormalHasTheMomentsOfItsLaw)
{
    ManyStreams streams(10);
    const Moments m = moments_about(0.0, [&] { return streams.next().normal(); });
    EXPECT_NEAR(m.mean, 0.0, bound(1.0));
    EXPECT_NEAR(m.second, 1.0, bound(2.0));
    EXPECT_NEAR(m.third, 0.0, bound(15.0));
    EXPECT_NEAR(m.fourth, 3.0, bound(96.0));
}

TEST(Random, GammaHasTheMomentsOfItsLaw)
{
    for (const double shape : {0.3, 1.0, 1.8333, 7.5}) {
        ManyStreams streams(11);
        const Moments m = moments_about(shape, [&] { return streams.next().gamma(shape); });
        EXPECT_NEAR(m.mean, shape, bound(shape)) << "shape " << shape;
        EXPECT_NEAR(m.second, shape, bound(2.0 * shape * shape + 6.0 * shape)) << "shape " << shape;
    }
}

// P(X > x) = exp(-x) for shape 1: the whole distribution, not only its moments (Kolmogorov's statistic, 4 sigma ~ 1.95 / sqrt(N)).
TEST(Random, GammaOfShapeOneIsExponential)
{
    ManyStreams streams(12);
    std::vector<double> values(samples);
    for (double& value : values) value = streams.next().gamma(1.0);
    std::sort(values.begin(), values.end());
    double farthest = 0;
    for (int i = 0; i < samples; ++i) {
        const double law = 1.0 - std::exp(-values[i]);
        farthest = std::max({farthest, std::abs(law - static_cast<double>(i) / samples), std::abs(law - (i + 1.0) / samples)});
    }
    EXPECT_LT(farthest, 1.95 / std::sqrt(samples));
}

TEST(Random, DirectionsAreUnitVectorsWithoutPreference)
{
    ManyStreams streams(13);
    Vector3d mean, square, mixed;
    for (int i = 0; i < samples; ++i) {
        const Vector3d d(streams.next().direction());
        ASSERT_NEAR(norm(d), 1.0, 1e-6);
        mean += d / samples;
        square += scaled(d, d) / samples;
        mixed += Vector3d(d.y * d.z, d.z * d.x, d.x * d.y) / samples;
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(mean[axis], 0.0, bound(1.0 / 3));
        EXPECT_NEAR(square[axis], 1.0 / 3, bound(1.0 / 5 - 1.0 / 9));
        EXPECT_NEAR(mixed[axis], 0.0, bound(1.0 / 15));
    }
}

/// The first words of a stream, as one comparable thing.
std::array<std::uint32_t, 6> start_of(Random stream)
{
    std::array<std::uint32_t, 6> words{};
    for (std::uint32_t& word : words) word = stream.word();
    return words;
}

TEST(Random, AStreamIsItsKeysAndNothingElse)
{
    EXPECT_EQ(start_of({5, Purpose::fill, 2, 9}), start_of({5, Purpose::fill, 2, 9}));
    std::set<std::array<std::uint32_t, 6>> streams;
    const std::uint64_t far = std::uint64_t{1} << 32;
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, far, far + 1}) {
        for (const Purpose purpose : {Purpose::fill, Purpose::collide, Purpose::inflow, Purpose::contact, Purpose::packing}) {
            for (const std::uint64_t step : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}}) {
                for (const std::uint64_t index : {std::uint64_t{0}, std::uint64_t{1}, far, 3 * far}) {
                    streams.insert(start_of({seed, purpose, step, index}));
                }
            }
        }
    }
    EXPECT_EQ(streams.size(), 4u * 5u * 3u * 4u);
}

TEST(Random, NeighbouringStreamsAreNotCorrelated)
{
    const auto first = [](std::uint64_t step, std::uint64_t index) { return Random(1, Purpose::collide, step, index).uniform() - 0.5; };
    double by_index = 0, by_step = 0;
    for (int i = 0; i < samples; ++i) {
        by_index += first(0, i) * first(0, i + 1);
        by_step += first(i, 0) * first(i + 1, 0);
    }
    EXPECT_NEAR(by_index / samples, 0.0, bound(1.0 / 144));
    EXPECT_NEAR(by_step / samples, 0.0, bound(1.0 / 144));
}

}  // namespace
}  // namespace corpuscle
