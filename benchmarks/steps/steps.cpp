// The time of a step: steplab's methods beside hand-written loops, Boost.odeint, GSL and SUNDIALS on the same scene, in
// one process, interleaved. Prints one line of CSV for each: the least time of all batches of steps of all repetitions,
// and for steplab the hash of the state at the end of a batch, which begins at the scene's start.
// Usage: steps [--benchmark_filter=REGEX on row/method/precision] [further options of Google Benchmark]

#include "core/flush_subnormals.hpp"
#include "sim/ensemble.hpp"
#include "sim/simulation.hpp"
#include "sim/spread.hpp"
#include "stepping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <utility>

namespace steplab::benchmark {

namespace google = ::benchmark;

struct Row {
    std::string_view id, model, parameter;
    double value;  ///< of the parameter
    double dt;
    std::size_t
        steps;  ///< of a batch: where it is short, with its share of steplab's checks of the energy, each 256 steps
    std::vector<std::string_view> methods;
    std::size_t runs = 1;  ///< of an ensemble that differ in k: the time is of a step of one of them
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"chain-10", "chain", "n", 10, 0.1, 64 * 256, {"euler", "velocity-verlet", "midpoint", "rk4"}},
        {"chain-10-ensemble", "chain", "n", 10, 0.1, 64 * 256, {"euler", "velocity-verlet", "rk4"}, 64},
        {"chain-100000", "chain", "n", 100000, 0.1, 256, {"euler", "velocity-verlet", "midpoint", "rk4"}},
        {"mesh-100x100", "mesh", "dim", 100, 0.1, 256, {"euler", "velocity-verlet", "rk4"}},
        {"mesh-1000x1000", "mesh", "dim", 1000, 0.1, 32, {"euler", "velocity-verlet", "rk4"}},
        {"morse-28", "morse", "edge", 3, 0.01, 4 * 256, {"velocity-verlet", "rk4"}},
    };
    return all;
}

RunDescription description_of(const Row& row, std::string_view method, Precision precision) {
    RunDescription description = describe(row.model, method);
    description.scene.set(row.parameter, row.value);
    description.precision = precision;
    description.dt = row.dt;
    return description;
}

Contestant ourselves(const RunDescription& description) {
    return {"steplab", [description] {
                auto simulation = std::make_shared<Simulation>(description, Execution{.threads = 1});
                return Stepping{[simulation](std::size_t steps) { simulation->advance(steps); },
                                [simulation] { return simulation->hash(); }};
            }};
}

/// Every time from the start, which counts; a batch is the steps of all runs together.
Contestant our_ensemble(const RunDescription& description, std::size_t runs) {
    return {"steplab", [description, runs] {
                return Stepping{[description, runs](std::size_t steps) {
                                    const std::vector<Spread> spreads{{"k", 1, 2}};
                                    std::vector<EnsembleRun> all;
                                    for (std::size_t i = 0; i < runs; ++i)
                                        all.push_back({spread_run(description, spreads, i, runs), steps / runs});
                                    run_ensemble(all, steps, {.threads = 1});
                                },
                                {}};
            }};
}

std::vector<Contestant> peers_of(const Simulation& simulation) {
    const RunDescription& run = simulation.description();
    const Frame start = simulation.frame();
    const Problem problem{run.model, run.method, run.dt, start.positions, start.velocities};
    return run.precision == Precision::float_ ? peers_in_float(problem) : peers_in_double(problem);
}

/// Batches from the start; what comes before a batch fills the caches and is not counted.
void measure(google::State& state, const Contestant& contestant, std::size_t steps, std::size_t particles) {
    const std::size_t warm_up = std::max<std::size_t>(1, steps / 16);
    double least = std::numeric_limits<double>::infinity();
    std::string hash;
    for ([[maybe_unused]] auto _ : state) {
        const Stepping stepping = contestant.start();
        stepping.advance(warm_up);
        const auto begin = std::chrono::steady_clock::now();
        stepping.advance(steps);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        state.SetIterationTime(spent.count());
        least = std::min(least, spent.count());
        if (stepping.hash) hash = stepping.hash();
    }
    state.SetLabel(hash);
    state.counters["ns_per_step"] = least * 1e9 / static_cast<double>(steps);
    state.counters["particles"] = static_cast<double>(particles);
}

/// One line for each contestant of a comparison, in the order in which they were entered.
class Lines : public google::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        const Run& first = runs.front();
        if (first.run_type != Run::RT_Iteration) return;  // means and deviations
        double least = std::numeric_limits<double>::infinity();
        for (const Run& run : runs) least = std::min<double>(least, run.counters.at("ns_per_step"));
        const std::string name = first.run_name.function_name;  // row/method/precision/who
        const auto slash = name.rfind('/');
        const double particles = first.counters.at("particles");
        std::string line = fmt::format("{}/{}/{}/{:.2f}/{:.4f}/{}\n", name.substr(0, slash), particles,
                                       name.substr(slash + 1), least, least / particles, first.report_label);
        std::replace(line.begin(), line.end(), '/', ',');
        lines_[first.family_index] = line;
    }

    void Finalize() override {
        for (const auto& [index, line] : lines_) fmt::print("{}", line);
        std::fflush(stdout);
        lines_.clear();
    }

private:
    std::map<std::int64_t, std::string> lines_;
};

void compare(const Row& row, std::string_view method, Precision precision, Lines& lines) {
    const RunDescription description = description_of(row, method, precision);
    const Simulation simulation(description);
    const std::size_t particles = simulation.particles(), steps = row.steps;
    google::ClearRegisteredBenchmarks();
    const auto enter = [&](const Contestant& contestant, std::size_t batch) {
        const std::string name = fmt::format("{}/{}/{}/{}", row.id, method, id(precision), contestant.who);
        google::RegisterBenchmark(name.c_str(), [=](google::State& state) {
            measure(state, contestant, batch, particles);
        })->UseManualTime();
    };
    if (row.runs > 1) {
        enter(our_ensemble(description, row.runs), steps * row.runs);
    } else {
        enter(ourselves(description), steps);
        for (const Contestant& peer : peers_of(simulation)) enter(peer, steps / 4);  // without checks, all alike
    }
    google::RunSpecifiedBenchmarks(&lines, "all");
}

void compare_all() {
    const std::string filter = google::GetBenchmarkFilter();
    const std::regex wanted(filter == "all" ? "" : filter);
    Lines lines;
    fmt::print("row,method,precision,particles,who,ns_per_step,ns_per_particle,hash\n");
    for (const Row& row : rows()) {
        for (const std::string_view method : row.methods) {
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                if (std::regex_search(fmt::format("{}/{}/{}", row.id, method, id(precision)), wanted))
                    compare(row, method, precision, lines);
            }
        }
    }
}

}  // namespace steplab::benchmark

int main(int argc, char** argv) {
    std::string defaults[] = {"--benchmark_enable_random_interleaving=true", "--benchmark_repetitions=5",
                              "--benchmark_min_time=0.02"};
    std::vector<char*> arguments{argv[0]};
    for (std::string& option : defaults) arguments.push_back(option.data());
    arguments.insert(arguments.end(), argv + 1, argv + argc);  // those given count, as they come last
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    const steplab::FlushSubnormals flush;  // for the peers too
    steplab::benchmark::compare_all();
}
