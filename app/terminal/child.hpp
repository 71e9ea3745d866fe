#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace corpuscle {

/// A program that runs beside this one: its standard output goes nowhere, its errors where ours go.
class Child {
public:
    /// Starts words[0] with the other words. Throws Error if it cannot be started.
    explicit Child(const std::vector<std::string>& words);

    /// Its exit code once it has ended (128 and the signal that killed it, as shells count).
    [[nodiscard]] std::optional<int> ended();

    /// Sends it SIGTERM. A Ctrl-C that reached it too does no harm: the two are told apart.
    void ask_to_stop() const;

private:
    pid_t process_ = 0;
    std::optional<int> code_;
};

}  // namespace corpuscle
