/// An oscillator for very long, in the steps of one method, against what theory says of them without rounding:
///     long_time METHOD STEPS
/// prints a row of a table for each precision, without and with compensated sums. Judges nothing: it takes minutes.

#include "methods/implicit-midpoint.hpp"
#include "methods/pefrl.hpp"
#include "methods/rk4.hpp"
#include "methods/srkn-11b.hpp"
#include "methods/velocity-verlet.hpp"
#include "methods/verlet.hpp"
#include "support/oscillator_theory.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace steplab::test {
namespace {

constexpr double dt = 0.1;

/// One of each family.
Map map_of(const std::string& method, long double step) {
    if (method == "verlet") return step_map<Verlet>(step);
    if (method == "velocity-verlet") return step_map<VelocityVerlet>(step);
    if (method == "pefrl") return step_map<Pefrl>(step);
    if (method == "srkn-11b") return step_map<Srkn11b>(step);
    if (method == "rk4") return step_map<Rk4>(step);
    if (method == "implicit-midpoint") return step_map<ImplicitMidpoint>(step);
    if (method == "gauss-16" || steplab::method(method).info.adaptive) return exact_map(step);
    throw std::runtime_error("no theory here for " + method);
}

void print_row(const RunDescription& run, std::uint64_t steps, const std::string& sums) {
    const Map map = map_of(run.method, as_held(run).dt);
    const std::uint64_t looks[] = {steps / 100, steps / 10, steps};
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Deviation> found = deviations(run, map, looks);
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    fmt::print("| `{}` | {} | {} |", run.method, id(run.precision), sums);
    for (const Deviation& deviation : found) fmt::print(" {:.1e} | {:.1e} |", deviation.phase, deviation.energy);
    fmt::print(" {:.0f} |\n", taken.count() / static_cast<double>(steps));
    std::fflush(stdout);
}

void print_rows(const std::string& id, std::uint64_t steps) {
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        const RunDescription plain = oscillator(id, precision, dt, false);
        print_row(plain, steps, "plain");
        if (plain.method_parameters.contains("compensated"))
            print_row(oscillator(id, precision, dt, true), steps, "compensated");
    }
}

}  // namespace
}  // namespace steplab::test

int main(int count, char** arguments) {
    if (count != 3) {
        fmt::print(stderr, "usage: long_time METHOD STEPS\n");
        return 2;
    }
    try {
        steplab::test::print_rows(arguments[1], std::strtoull(arguments[2], nullptr, 10));
    } catch (const std::exception& error) {
        fmt::print(stderr, "long_time: {}\n", error.what());
        return 1;
    }
}
