#include "base/clock.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

TEST(Clock, StandsAtZeroBeforeTheFirstStep)
{
    const Clock clock;
    EXPECT_EQ(clock.time(), 0.0);
    EXPECT_EQ(clock.end(), 0.0);
    EXPECT_EQ(clock.step(), 0u);
}

TEST(Clock, AStepLiesBetweenTimeAndEnd)
{
    Clock clock;
    clock.begin_step(0.25);
    EXPECT_EQ(clock.time(), 0.0);
    EXPECT_EQ(clock.end(), 0.25);
    EXPECT_EQ(clock.duration(), 0.25);
    EXPECT_EQ(clock.previous_duration(), 0.0);
    clock.end_step();
    EXPECT_EQ(clock.time(), 0.25);
    EXPECT_EQ(clock.step(), 1u);
}

TEST(Clock, RemembersHowLongTheStepBeforeWas)
{
    Clock clock;
    for (const double duration : {0.5, 0.25, 0.125}) {
        clock.begin_step(duration);
        clock.end_step();
    }
    EXPECT_EQ(clock.duration(), 0.125);
    EXPECT_EQ(clock.previous_duration(), 0.25);
    EXPECT_EQ(clock.time(), 0.875);
    EXPECT_EQ(clock.step(), 3u);
}

TEST(Clock, GoesOnFromASavedState)
{
    Clock whole, resumed;
    whole.begin_step(0.1);
    whole.end_step();
    resumed.restore(whole.time(), whole.duration(), whole.previous_duration(), whole.step());
    for (Clock* clock : {&whole, &resumed}) {
        clock->begin_step(0.07);
        clock->end_step();
    }
    EXPECT_EQ(resumed.time(), whole.time());
    EXPECT_EQ(resumed.previous_duration(), whole.previous_duration());
    EXPECT_EQ(resumed.step(), whole.step());
}

}  // namespace
}  // namespace corpuscle
