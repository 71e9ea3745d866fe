#pragma once

#include <map>
#include <string>
#include <vector>

#include "fields/field.hpp"
#include "fields/transfer.hpp"
#include "gas/domain.hpp"

namespace corpuscle {

/// What a body holds, or what all bodies hold together.
using Holding = Passage;

/// How far the books are from closing, relative to the mass, momentum and energy that took part.
struct LedgerError {
    double mass = 0;
    double momentum = 0;
    double energy = 0;
};

/// The books of a run: what the bodies held at the start, who gave what to whom since then, and what they hold now. What came
/// from outside must be found in the bodies; what is not found is the error.
class Ledger {
public:
    /// Opens the books with what all bodies hold at the start.
    void open(const Holding& held);

    /// Enters what was given. Bodies are "gas", "explosive" and "structure"; every other name is the world outside.
    void add(const Transfer& transfer);
    void add(const std::vector<Transfer>& transfers);

    /// Closes a step with what all bodies hold now.
    void close_step(const Holding& held);

    [[nodiscard]] const LedgerError& error() const { return error_; }
    /// Who gave what to whom since the start, by names.
    [[nodiscard]] std::vector<Transfer> totals() const;
    /// Mass, momentum and energy by which errors are measured: what was there and what came in [kg, kg m/s, J].
    [[nodiscard]] double energy_scale() const;
    [[nodiscard]] double mass_scale() const;
    [[nodiscard]] double momentum_scale() const;

    /// For a restart; valid while the ledger lives.
    [[nodiscard]] FieldSet state();

private:
    void take_up();

    Holding initial_;
    Holding from_outside_;  ///< net
    double mass_in_ = 0;    ///< that came in, not net [kg]
    double energy_in_ = 0;  ///< work and energy that came in, not net [J]
    LedgerError error_;
    std::map<std::pair<std::string, std::string>, Transfer> entries_;
    std::vector<double> saved_numbers_;  ///< as a restart holds them
    std::vector<std::uint8_t> saved_names_;
};

}  // namespace corpuscle
