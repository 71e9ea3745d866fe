#include "model/ledger.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

const Holding start{10, {1, 2, 3}, 1000};

const Transfer* entry(const std::vector<Transfer>& totals, const std::string& from, const std::string& to)
{
    for (const Transfer& transfer : totals) {
        if (transfer.from == from && transfer.to == to) return &transfer;
    }
    return nullptr;
}

/// Transfers of every kind: between bodies, in, out, and between strangers.
std::vector<Transfer> dealings()
{
    return {{"gas", "structure", 0, {0, 0, 5}, 40},    {"explosive", "gas", 2, {}, 300},           {"ambient", "gas", 0.5, {1, 0, 0}, 20},
            {"gas", "open edge", 0.25, {0, 3, 0}, 10}, {"support", "structure", 0, {0, 0, -4}, 0}, {"conwep", "world", 9, {9, 9, 9}, 9}};
}

/// What the bodies hold after these dealings.
const Holding after{10 + 0.5 - 0.25, {1 + 1, 2 - 3, 3 - 4}, 1000 + 20 - 10};

TEST(Ledger, closes_where_what_came_from_outside_is_found)
{
    Ledger ledger;
    ledger.open(start);
    ledger.close_step(start);
    EXPECT_EQ(ledger.error().mass, 0);
    EXPECT_EQ(ledger.error().momentum, 0);
    EXPECT_EQ(ledger.error().energy, 0);
    ledger.add(dealings());
    ledger.close_step(after);
    EXPECT_NEAR(ledger.error().mass, 0, 1e-15);
    EXPECT_NEAR(ledger.error().momentum, 0, 1e-15);
    EXPECT_NEAR(ledger.error().energy, 0, 1e-15);
}

TEST(Ledger, measures_what_is_not_found)
{
    Ledger ledger;
    ledger.open(start);
    ledger.add(dealings());
    Holding wrong = after;
    wrong += {-0.1, {0, 0, 0.3}, 2};
    ledger.close_step(wrong);
    EXPECT_NEAR(ledger.error().mass, 0.1 / 10.5, 1e-12);
    EXPECT_NEAR(ledger.error().energy, 2 / 1020.0, 1e-12);
    EXPECT_NEAR(ledger.error().momentum, 0.3 / std::sqrt(2 * 10.5 * 1020), 1e-12);
    EXPECT_NEAR(ledger.mass_scale(), 10.5, 1e-12);
    EXPECT_NEAR(ledger.energy_scale(), 1020, 1e-12);
}

TEST(Ledger, forgets_to_enter_nothing)
{
    Ledger ledger;
    ledger.open(start);
    for (int i = 0; i < 3; ++i) ledger.add(dealings());
    const std::vector<Transfer> totals = ledger.totals();
    EXPECT_EQ(totals.size(), dealings().size());
    for (const Transfer& one : dealings()) {
        const Transfer* all = entry(totals, one.from, one.to);
        ASSERT_NE(all, nullptr) << one.from << " to " << one.to;
        EXPECT_DOUBLE_EQ(all->mass, 3 * one.mass);
        EXPECT_DOUBLE_EQ(all->energy, 3 * one.energy);
        EXPECT_NEAR(norm(all->momentum - 3.0 * one.momentum), 0, 1e-12);
    }
}

/// A body that only gives work away does not make the scale smaller; opening begins anew.
TEST(Ledger, scale_counts_what_came_in_and_opening_begins_anew)
{
    Ledger ledger;
    ledger.open(start);
    ledger.add({"structure", "support", 0, {}, 600});
    EXPECT_EQ(ledger.energy_scale(), 1000);
    ledger.add({"support", "structure", 0, {}, 500});
    EXPECT_EQ(ledger.energy_scale(), 1500);
    ledger.open(start);
    EXPECT_EQ(ledger.energy_scale(), 1000);
    EXPECT_TRUE(ledger.totals().empty());
    ledger.close_step(start);
    EXPECT_EQ(ledger.error().energy, 0);
}

/// An empty run has no scale: what appears is shown as it is.
TEST(Ledger, without_anything_shows_absolute_errors)
{
    Ledger ledger;
    ledger.open({});
    ledger.close_step({0.5, {}, 3});
    EXPECT_EQ(ledger.error().mass, 0.5);
    EXPECT_EQ(ledger.error().energy, 3);
}

TEST(Ledger, comes_back_from_a_restart)
{
    Ledger ledger;
    ledger.open(start);
    ledger.add(dealings());
    std::vector<std::vector<std::byte>> saved;
    const FieldSet set = ledger.state();
    for (const Field& field : set.fields) {
        saved.emplace_back(field.count * size_of(field.scalar));
        field.gather(saved.back().data());
    }
    Ledger other;
    other.add({"nobody", "gas", 1, {}, 1});
    const FieldSet target = other.state();
    for (std::size_t f = 0; f < set.fields.size(); ++f) target.fields[f].restore(saved[f].data(), set.fields[f].count);

    for (Ledger* book : {&ledger, &other}) {
        book->add({"ambient", "gas", 1, {0, 1, 0}, 7});
        Holding held = after;
        held += {1.25, {0, 1, 0}, 7};
        book->close_step(held);
    }
    EXPECT_NEAR(other.error().mass, 0.25 / 11.5, 1e-12);
    EXPECT_EQ(other.error().mass, ledger.error().mass);
    EXPECT_EQ(other.error().momentum, ledger.error().momentum);
    EXPECT_EQ(other.error().energy, ledger.error().energy);
    EXPECT_EQ(other.energy_scale(), ledger.energy_scale());
    const std::vector<Transfer> totals = ledger.totals(), restored = other.totals();
    ASSERT_EQ(totals.size(), restored.size());
    for (std::size_t i = 0; i < totals.size(); ++i) {
        EXPECT_EQ(totals[i].from, restored[i].from);
        EXPECT_EQ(totals[i].to, restored[i].to);
        EXPECT_EQ(totals[i].mass, restored[i].mass);
        EXPECT_EQ(totals[i].momentum, restored[i].momentum);
        EXPECT_EQ(totals[i].energy, restored[i].energy);
    }
}

}  // namespace
}  // namespace corpuscle
