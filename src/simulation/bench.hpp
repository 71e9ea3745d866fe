#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace corpuscle {

/// One measured loop: wall time for each thing it works on in a step.
struct BenchLine {
    std::string name;  ///< "gas: collide", "reference: triad", ...
    int threads = 1;
    double nanoseconds = 0;  ///< wall, of a thing and a step; the median of several repeats
    double ratio = 0;        ///< over the reference copy of 32-byte records with as many threads, in the same run
    double moved = 0;        ///< least bytes that memory must move for each thing; 0 where that says nothing
    double limit = 0;        ///< how many times as long as moving them takes the copy in order, with as many threads
    double resident = 0;     ///< bytes for each thing; 0 where that says nothing
};

/// What to measure.
struct BenchSettings {
    std::string name;  ///< "gas", "sizes", "shells", "euler", "reference"; all but "sizes" if empty
    std::size_t particles = 1'000'000;
    int steps = 20;  ///< of the gas
    std::vector<int> threads{1, 2};
};

/// Names that can be asked for.
[[nodiscard]] const std::vector<std::string>& bench_names();

/// Times reference loops (triad; copies of 32-byte records in order, nearly in order, and at random), the gas step in a closed box of
/// colliding gas with its phases, the same from 1e5 to 2e7 particles ("sizes"), the shell step of the plate, and a step
/// of products and air on the Eulerian grid. Throws InputError for a
/// name that is none.
[[nodiscard]] std::vector<BenchLine> run_bench(const BenchSettings& settings);

/// The lines as JSON, for scripts.
[[nodiscard]] std::string bench_json(const std::vector<BenchLine>& lines);

}  // namespace corpuscle
