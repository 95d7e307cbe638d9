/// How much longer a step takes when motion has decayed to the smallest numbers: of a damped chain, as all stepping
/// threads run it (subnormal numbers flushed to zero), and with subnormal numbers left to the processor. Prints ratios,
/// judges nothing.

#include "core/flush_subnormals.hpp"
#include "sim/run/segment.hpp"
#include "support/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace steplab::test {
namespace {

constexpr std::uint64_t batch = 2000;

double seconds(Stepper& stepper) {
    const auto begin = std::chrono::steady_clock::now();
    stepper.advance(batch);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Time of a batch of steps after the decay over that of one before it, each the least of many taken in turn.
double slow_down(const RunDescription& run) {
    RunDescription undamped = run;
    undamped.scene.set("c", 1e-6);
    const Segment fresh(undamped), late(run);
    late.stepper->advance(60000);
    double lively = infinity, decayed = infinity;
    for (int round = 0; round < 100; ++round) {
        lively = std::min(lively, seconds(*fresh.stepper));
        decayed = std::min(decayed, seconds(*late.stepper));
    }
    return decayed / lively;
}

void print_row(std::string_view method, Precision precision) {
    const RunDescription run = run_of("chain", method, precision, 0.1, {{"n", 4}, {"c", 1}, {"v0", 1}});
    const double plain = slow_down(run);
    const FlushSubnormals flush;
    fmt::print("| `{}` | {} | {:.2f} | {:.2f} |\n", method, id(precision), slow_down(run), plain);
}

}  // namespace
}  // namespace steplab::test

int main() {
    fmt::print("| method | precision | flushed | not flushed |\n|---|---|---|---|\n");
    for (const char* method : {"euler", "velocity-verlet", "rk4", "kahan-li-8"}) {
        for (const steplab::Precision precision : steplab::test::precisions)
            steplab::test::print_row(method, precision);
    }
}
