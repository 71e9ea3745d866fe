#pragma once

#include <atomic>

namespace corpuscle {

/// While it lives, Ctrl-C and SIGTERM ask for a stop instead of killing; the second one kills.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// Set once a stop is asked for.
    [[nodiscard]] const std::atomic<bool>& requested() const;
};

}  // namespace corpuscle
