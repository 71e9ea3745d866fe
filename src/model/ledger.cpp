#include "model/ledger.hpp"

#include <cmath>
#include <utility>

namespace corpuscle {

namespace {

bool is_body(const std::string& name)
{
    return name == "gas" || name == "explosive" || name == "structure";
}

double relative(double difference, double scale)
{
    return scale > 0 ? std::abs(difference) / scale : std::abs(difference);
}

}  // namespace

void Ledger::open(const Holding& held)
{
    *this = {};
    initial_ = held;
}

void Ledger::add(const Transfer& transfer)
{
    Transfer& entry = entries_[{transfer.from, transfer.to}];
    entry.from = transfer.from;
    entry.to = transfer.to;
    entry.mass += transfer.mass;
    entry.momentum += transfer.momentum;
    entry.energy += transfer.energy;
    const double sign = (is_body(transfer.to) ? 1 : 0) - (is_body(transfer.from) ? 1 : 0);
    if (sign == 0) return;
    from_outside_ += {sign * transfer.mass, sign * transfer.momentum, sign * transfer.energy};
    mass_in_ += std::max(0.0, sign * transfer.mass);
    energy_in_ += std::max(0.0, sign * transfer.energy);
}

void Ledger::add(const std::vector<Transfer>& transfers)
{
    for (const Transfer& transfer : transfers) add(transfer);
}

void Ledger::close_step(const Holding& held)
{
    error_.mass = relative(held.mass - initial_.mass - from_outside_.mass, mass_scale());
    error_.momentum = relative(norm(held.momentum - initial_.momentum - from_outside_.momentum), momentum_scale());
    error_.energy = relative(held.energy - initial_.energy - from_outside_.energy, energy_scale());
}

std::vector<Transfer> Ledger::totals() const
{
    std::vector<Transfer> list;
    for (const auto& [names, entry] : entries_) list.push_back(entry);
    return list;
}

double Ledger::energy_scale() const
{
    return initial_.energy + energy_in_;
}

double Ledger::mass_scale() const
{
    return initial_.mass + mass_in_;
}

double Ledger::momentum_scale() const
{
    return std::sqrt(2 * mass_scale() * energy_scale());
}

/// The books as one array of numbers and one of names, so that a restart need not know who deals with whom.
FieldSet Ledger::state()
{
    FieldSet set{"ledger", {}};
    saved_numbers_ = {initial_.mass,
                      initial_.momentum.x,
                      initial_.momentum.y,
                      initial_.momentum.z,
                      initial_.energy,
                      from_outside_.mass,
                      from_outside_.momentum.x,
                      from_outside_.momentum.y,
                      from_outside_.momentum.z,
                      from_outside_.energy,
                      mass_in_,
                      energy_in_};
    saved_names_.clear();
    for (const auto& [names, entry] : entries_) {
        saved_numbers_.insert(saved_numbers_.end(), {entry.mass, entry.momentum.x, entry.momentum.y, entry.momentum.z, entry.energy});
        for (const char c : entry.from + ">" + entry.to + ";") saved_names_.push_back(static_cast<std::uint8_t>(c));
    }
    Field names = stored_field("names", "1", "who gave to whom", saved_names_);
    names.restore = [this](const void* values, std::size_t count) {
        saved_names_.assign(static_cast<const std::uint8_t*>(values), static_cast<const std::uint8_t*>(values) + count);
    };
    Field numbers = stored_field("numbers", "1", "mass, momentum and energy at the start, from outside, and of each entry", saved_numbers_);
    numbers.restore = [this](const void* values, std::size_t count) {
        saved_numbers_.assign(static_cast<const double*>(values), static_cast<const double*>(values) + count);
        take_up();
    };
    set.fields = {std::move(names), std::move(numbers)};
    return set;
}

void Ledger::take_up()
{
    const auto holding = [this](std::size_t at) {
        const std::vector<double>& n = saved_numbers_;
        return Holding{n[at], {n[at + 1], n[at + 2], n[at + 3]}, n[at + 4]};
    };
    initial_ = holding(0);
    from_outside_ = holding(5);
    mass_in_ = saved_numbers_[10];
    energy_in_ = saved_numbers_[11];
    entries_.clear();
    std::string from, text;
    std::size_t at = 12;
    for (const std::uint8_t letter : saved_names_) {
        if (letter == '>') {
            from = std::exchange(text, "");
        } else if (letter == ';') {
            const Holding given = holding(at);
            entries_[{from, text}] = {from, text, given.mass, given.momentum, given.energy};
            text.clear();
            at += 5;
        } else {
            text += static_cast<char>(letter);
        }
    }
}

}  // namespace corpuscle
