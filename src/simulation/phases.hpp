#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle {

/// Wall time of each word of the step, in the step's order.
class Phases {
public:
    /// Runs `work` and books its wall time under `name`.
    template <class Work>
    void time(const char* name, const Work& work)
    {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds(name) += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    [[nodiscard]] const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

private:
    double& seconds(const char* name)
    {
        for (auto& [known, value] : seconds_) {
            if (known == name) return value;
        }
        return seconds_.emplace_back(name, 0.0).second;
    }

    std::vector<std::pair<std::string, double>> seconds_;  ///< [s]
};

}  // namespace corpuscle
