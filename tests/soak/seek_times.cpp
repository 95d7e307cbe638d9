// How long it takes to go to any step of a run of a million steps, and back step by step, and the memory that it keeps
// for that. Not a test: the numbers depend on the machine.

#include "session/time_line.hpp"
#include "support/runs.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

using namespace steplab;

namespace {

constexpr std::uint64_t steps = 1'000'000;

double milliseconds(const std::function<void()>& action) {
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void go_to(TimeLine& line, std::uint64_t step) {
    line.turn_to(step);
    line.advance(step - line.step());
}

/// Median and largest.
void print(const char* what, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    std::printf(", %s %.2f ms, at most %.2f", what, times[times.size() / 2], times.back());
}

void measure(const char* model, const char* method, double dt) {
    TimeLine line(test::run_of(model, method, Precision::double_, dt));
    // in the portions of a window that plays
    const double whole = milliseconds([&] {
        while (line.step() < steps) line.advance(5'000);
    });
    std::vector<double> seeks, back;
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        const std::uint64_t step = std::uniform_int_distribution<std::uint64_t>(0, steps)(random);
        seeks.push_back(milliseconds([&] { go_to(line, step); }));
    }
    go_to(line, steps);
    for (int i = 0; i < 60; ++i) back.push_back(milliseconds([&] { line.step_back(1); }));
    std::printf("%s, %s: %.0f ms for all steps", model, method, whole);
    print("to a step", seeks);
    print("a step back", back);
    std::printf(", %.1f MB\n", static_cast<double>(line.bytes()) / 1e6);
}

}  // namespace

int main() {
    measure("chain", "velocity-verlet", 0.1);
    measure("mesh", "rk4", 0.1);
    measure("morse", "velocity-verlet", 0.005);
    measure("morse", "gauss-16", 0.01);
}
