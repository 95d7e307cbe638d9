// The time of a step: steplab's methods beside hand-written loops, Boost.odeint, GSL and SUNDIALS on the same scene, in
// one process, interleaved; then an ensemble beside a single run; then steplab alone on scenes of 10 to 10^7 particles,
// by one thread and by more; then composed scenes beside the same; then what the machine can do at most. Prints one
// line of CSV for each: the least time of all batches of steps of all repetitions, and for steplab the hash of the
// state at the end of a batch, which begins at the scene's start. Usage: steps [--benchmark_filter=REGEX on
// row/method/precision] [further options of Google Benchmark]

#include "composed.hpp"
#include "core/flush_subnormals.hpp"
#include "core/team.hpp"
#include "lines.hpp"
#include "machine.hpp"
#include "sim/catalogue.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "sim/run/simulation.hpp"
#include "stepping.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
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
    bool sideways = false;  ///< with the last particle pulled off the axis along which the scene moves
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"chain-10", "chain", "n", 10, 0.1, 64 * 256, {"euler", "velocity-verlet", "midpoint", "rk4"}},
        {"chain-100000", "chain", "n", 100000, 0.1, 256, {"euler", "velocity-verlet", "midpoint", "rk4"}},
        {"chain-10-sideways", "chain", "n", 10, 0.1, 64 * 256, {"euler", "velocity-verlet", "rk4"}, true},
        {"chain-100000-sideways", "chain", "n", 100000, 0.1, 256, {"euler", "velocity-verlet", "rk4"}, true},
        {"mesh-100x100", "mesh", "dim", 100, 0.1, 256, {"euler", "velocity-verlet", "rk4"}},
        {"mesh-1000x1000", "mesh", "dim", 1000, 0.1, 32, {"euler", "velocity-verlet", "rk4"}},
        {"morse-28", "morse", "edge", 3, 0.01, 4 * 256, {"velocity-verlet", "rk4"}},
    };
    return all;
}

/// The rows that only LAMMPS computes too, as a program of its own (benchmarks/lammps/morse_bulk.in).
const std::vector<Row>& bulk_rows() {
    static const std::vector<Row> all{{"morse-bulk-4096", "crystal", "edge", 16, 0.005, 200, {"velocity-verlet"}},
                                      {"morse-bulk-32768", "crystal", "edge", 32, 0.005, 100, {"velocity-verlet"}},
                                      {"morse-bulk-262144", "crystal", "edge", 64, 0.005, 50, {"velocity-verlet"}}};
    return all;
}

/// Rows of an ensemble beside a single run of it.
const std::vector<Row>& ensemble_rows() {
    static const std::vector<Row> all{
        {"chain-10-ensemble", "chain", "n", 10, 0.1, 64 * 256, {"euler", "velocity-verlet", "rk4"}}};
    return all;
}

/// Rows of a scene that grows; peers have no part in them.
const std::vector<Row>& growing_rows() {
    static const std::vector<Row> all = [] {
        std::vector<Row> growing;
        const auto add = [&](std::string_view id, std::string_view model, std::string_view parameter,
                             std::initializer_list<double> values, int power) {
            for (const double value : values) {
                const double particles = std::pow(value, power);
                const std::size_t steps = particles > 2e5 ? 32 : particles > 2e4 ? 256 : particles > 2e3 ? 2560 : 10240;
                growing.push_back({id, model, parameter, value, 0.1, steps, {"velocity-verlet"}});
            }
        };
        add("growing-chain", "chain", "n", {10, 100, 1000, 1e4, 1e5, 1e6, 1e7}, 1);
        add("growing-mesh", "mesh", "dim", {10, 32, 100, 317, 1000, 3163}, 2);
        return growing;
    }();
    return all;
}

RunDescription description_of(const Row& row, std::string_view method, Precision precision) {
    RunDescription description = describe(row.model, method);
    description.scene.set(row.parameter, row.value);
    if (row.model == "crystal") description.scene.set("m", 1);  // as LAMMPS is told; the default is heavier
    description.precision = precision;
    description.dt = row.dt;
    return description;
}

void pull_sideways(Simulation& simulation) {
    const std::size_t last = simulation.particles() - 1;
    simulation.act(Pull{last, simulation.frame().positions[last] + Vec3{0, 1, 0.5}});
}

Contestant ourselves(const RunDescription& description, std::size_t threads, bool sideways = false) {
    return {threads > 1 ? fmt::format("steplab {} threads", threads) : "steplab", [=] {
                auto simulation = std::make_shared<Simulation>(description, Execution{.threads = threads});
                if (sideways) pull_sideways(*simulation);
                return Stepping{[simulation](std::size_t steps) { simulation->advance(steps); },
                                [simulation] { return simulation->hash(); }};
            }};
}

std::vector<EnsembleRun> runs_with_other_k(const RunDescription& description, std::size_t runs, std::uint64_t steps) {
    const std::vector<ParameterRange> ranges{{"k", 1, 2}};
    std::vector<EnsembleRun> all;
    for (std::size_t i = 0; i < runs; ++i) all.push_back({run_in_range(description, ranges, i, runs), {steps}});
    return all;
}

/// That of the hashes of all runs, one behind the other.
std::string hash_of(const std::vector<EnsembleResult>& results) {
    std::string hashes;
    for (const EnsembleResult& run : results) hashes += run.result.hash;
    return fmt::format("{:016x}", XXH64(hashes.data(), hashes.size(), 0));
}

/// Runs that differ in k, every time from the start, which counts; a batch is the steps of all runs together.
Contestant our_ensemble(const RunDescription& description, std::size_t runs) {
    return {"steplab ensemble", [description, runs] {
                auto results = std::make_shared<std::vector<EnsembleResult>>();
                return Stepping{[=](std::size_t steps) {
                                    *results = run_ensemble(runs_with_other_k(description, runs, steps / runs), steps,
                                                            {.threads = 1});
                                },
                                [results] { return hash_of(*results); }};
            }};
}

std::vector<Contestant> peers_of(const Simulation& simulation) {
    const RunDescription& run = simulation.description();
    const Frame start = simulation.frame();
    const Problem problem{run.model, run.method, run.dt, start.positions, start.velocities};
    return run.precision == Precision::float_ ? peers_in_float(problem) : peers_in_double(problem);
}

std::string name_of(const Row& row, std::string_view method, Precision precision) {
    return fmt::format("{}/{}/{}", row.id, method, id(precision));
}

Comparison with_peers(const Row& row, std::string_view method, Precision precision) {
    const RunDescription description = description_of(row, method, precision);
    Simulation simulation(description);
    if (row.sideways) pull_sideways(simulation);
    Comparison comparison{name_of(row, method, precision),
                          simulation.particles(),
                          {{ourselves(description, 1, row.sideways), row.steps}}};
    // without checks, each step of theirs is alike
    for (const Contestant& peer : peers_of(simulation)) comparison.entries.push_back({peer, row.steps / 4});
    return comparison;
}

Comparison with_ensemble(const Row& row, std::string_view method, Precision precision) {
    constexpr std::size_t runs = 64;
    const RunDescription description = description_of(row, method, precision);
    return {name_of(row, method, precision),
            static_cast<std::size_t>(model_of(description).particles(description.scene)),
            {{ourselves(description, 1), row.steps}, {our_ensemble(description, runs), row.steps * runs}}};
}

/// By one thread and, of many particles, by two, four ... of them.
Comparison with_threads(const Row& row, std::string_view method, Precision precision, std::size_t warm_up = 0) {
    constexpr double many = 1e5;
    const RunDescription description = description_of(row, method, precision);
    const double particles = model_of(description).particles(description.scene);
    Comparison comparison{name_of(row, method, precision), static_cast<std::size_t>(particles), {}};
    const std::size_t most = particles < 0.9 * many ? 1 : processors();
    for (std::size_t threads = 1; threads <= most; threads *= 2)
        comparison.entries.push_back({ourselves(description, threads), row.steps, warm_up});
    return comparison;
}

/// Batches after the same steps from the start, which fill the caches at least.
void measure(google::State& state, const Comparison::Entry& entry, std::size_t particles) {
    const auto& [contestant, steps, warm_up] = entry;
    double least = std::numeric_limits<double>::infinity();
    std::string hash;
    for ([[maybe_unused]] auto _ : state) {
        const Stepping stepping = contestant.start();
        stepping.advance(std::max(warm_up, std::max<std::size_t>(1, steps / 16)));
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
        std::istringstream name(first.run_name.function_name);
        std::string row, method, precision, who;
        for (std::string* const part : {&row, &method, &precision}) std::getline(name, *part, '/');
        std::getline(name, who);
        lines_[first.family_index] =
            text({row, method, precision, first.counters.at("particles"), who, least, first.report_label});
    }

    void Finalize() override {
        for (const auto& [index, line] : lines_) fmt::print("{}", line);
        std::fflush(stdout);
        lines_.clear();
    }

private:
    std::map<std::int64_t, std::string> lines_;
};

void run(const Comparison& comparison, Lines& lines) {
    google::ClearRegisteredBenchmarks();
    for (const Comparison::Entry& entry : comparison.entries) {
        const std::string name = fmt::format("{}/{}", comparison.name, entry.contestant.who);
        google::RegisterBenchmark(name.c_str(), [entry, particles = comparison.particles](google::State& state) {
            measure(state, entry, particles);
        })->UseManualTime();
    }
    google::RunSpecifiedBenchmarks(&lines, "all");
}

template <class Compared>
void run_rows(const std::vector<Row>& all, const std::regex& wanted, Lines& lines, Compared compared) {
    for (const Row& row : all) {
        for (const std::string_view method : row.methods) {
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                if (std::regex_search(name_of(row, method, precision), wanted))
                    run(compared(row, method, precision), lines);
            }
        }
    }
}

void run_all() {
    const std::string filter = google::GetBenchmarkFilter();
    const std::regex wanted(filter == "all" ? "" : filter);
    Lines lines;
    fmt::print("row,method,precision,particles,who,ns_per_step,ns_per_particle,hash\n");
    run_rows(rows(), wanted, lines, with_peers);
    // in the state that so many steps have led to as are then timed
    run_rows(bulk_rows(), wanted, lines, [](const Row& row, std::string_view method, Precision precision) {
        return with_threads(row, method, precision, row.steps);
    });
    run_rows(ensemble_rows(), wanted, lines, with_ensemble);
    run_rows(growing_rows(), wanted, lines, [](const Row& row, std::string_view method, Precision precision) {
        return with_threads(row, method, precision);
    });
    const auto by_threads = [](const RunDescription& run, std::size_t threads) { return ourselves(run, threads); };
    std::vector<Comparison> others =
        composed_comparisons(by_threads, [&](const std::string& name) { return std::regex_search(name, wanted); });
    std::ranges::move(machine_comparisons(), std::back_inserter(others));
    for (const Comparison& comparison : others) {
        if (std::regex_search(comparison.name, wanted)) run(comparison, lines);
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
    steplab::benchmark::run_all();
}
