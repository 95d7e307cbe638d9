// Time to an error: for each scene and error, the fastest method of steplab beside the fastest of Boost.odeint, GSL and
// SUNDIALS, in one process. Every method runs over a series of dt or tolerances; all runs that might win are timed in
// interleaved rounds and the least of each is kept. The libraries get the force once as a user writes it and once as
// compilers vectorise it (with -fno-math-errno). Three short scenes by default, errors of which are distances;
// `kepler`: eccentricity 0.9 over 100 periods, errors by the semi-major axis; `outer-solar-system`: 10^4 years, the
// largest error of any body by the semi-major axis of Jupiter. Usage: peers [chain|morse|mesh|kepler|outer-solar-system
// ...] [rounds]

#include "contest_plan.hpp"
#include "core/flush_subnormals.hpp"
#include "lab/study/speed_error.hpp"
#include "lines.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab::benchmark {

/// A run of somebody at one setting.
struct Entry {
    std::string who;  ///< library and method, with the setting
    int group = 0;    ///< 0 steplab, 1 libraries with the plain force, 2 with the gather force
    double error = 0;
    std::function<double()> seconds;
    double least = 1e300;
    std::function<std::string()> hash = [] { return std::string(); };  ///< of the state at the end, if it is ours
};

constexpr const char* programs[] = {"steplab", "odeint", "GSL", "SUNDIALS"};
/// Of a series with smaller errors it is expected that finer settings gain.
constexpr double converging = 1e-3;

double seconds_of(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string hash_at_the_end(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    return simulation.hash();
}

class Contest {
public:
    explicit Contest(const ContestPlan& plan) : plan_(plan), reference_(reference_for(plan_.study)) {
        const Problem problem = problem_of(plan_);
        for (const Solver& solver : plain_solvers(problem)) enter(solver, 1);
        for (const Solver& solver : gather_solvers(problem)) enter(solver, 2);
        StudyPlan& study = plan_.study;
        for (const std::string& id : possible_methods(study)) {
            if (run_over(study, id, Precision::double_, 1).method_parameters.contains("tolerance"))
                enter_tolerances(id);
        }
        std::erase_if(study.methods, [](const std::string& id) { return method(id).info.adaptive; });
        for (const Measurement& run : measure_series(study, reference_, [](double) {})) enter(run);
    }

    void hold(int rounds) {
        drop_hopeless();
        for (int round = 0; round < rounds; ++round) {
            for (Entry& entry : entries_) entry.least = std::min(entry.least, entry.seconds());
        }
    }

    /// The fastest of steplab and of the libraries with either force, for each error.
    void print_lines() const {
        const std::string row = fmt::format("error-{}", plan_.name);
        const double particles = model_of(plan_.study.scene).particles(plan_.study.scene.scene);
        for (const double target : plan_.targets) {
            const std::string error = fmt::format("{:.0e}", target);
            const auto add = [&](const std::string& who, const Entry& entry) {
                benchmark::print({row, error, "double", particles, who, entry.least * 1e9, entry.hash()});
            };
            if (const Entry* own = best(0, target)) add("steplab " + own->who, *own);
            const Entry *plain = best(1, target), *gather = best(2, target);
            if (plain) add(plain->who + " plain", *plain);
            if (gather) add(gather->who + " gather", *gather);
        }
    }

    void print_table() const {
        fmt::print("\n{} to t = {}, reference: {} ({:.0e})\n", plan_.name, plan_.study.time, reference_.how,
                   reference_.moments.back().error / plan_.length);
        fmt::print("{:<7} {:>10}  {:<30} {:>10} {:>6}  {:<34} {:>10} {:>6}  {}\n", "error", "steplab", "", "plain",
                   "ratio", "", "gather", "ratio", "");
        for (const double target : plan_.targets) {
            const Entry *own = best(0, target), *plain = best(1, target), *gather = best(2, target);
            fmt::print("{:<7.0e} {}  {} {}  {}\n", target, cell(own, 30), cell(plain, own, 34), cell(gather, own, 34),
                       "");
        }
        if (plan_.smallest) print_smallest();
    }

private:
    void print_smallest() const {
        fmt::print("smallest error that each program reaches\n");
        for (const char* program : programs) {
            const Entry* const entry = most_exact(program);
            if (entry) fmt::print("{:<10} {:>7.1e} {}\n", program, entry->error, cell(entry, 30));
        }
    }

    static std::string setting(const RunDescription& run) {
        if (run.method_parameters.contains("tolerance") && run.method_parameters["tolerance"] > 0)
            return fmt::format("{:.0e}", run.method_parameters["tolerance"]);
        return fmt::format("dt {:.3g}", run.dt);
    }

    void enter(const Measurement& run) {
        if (run.diverged()) return;
        entries_.push_back({fmt::format("{} {}", run.run.method, setting(run.run)), 0, run.error / plan_.length,
                            [run] { return stepping_seconds(run.run, run.steps); }, run.wall_seconds.value_or(1e300),
                            [run] { return hash_at_the_end(run.run, run.steps); }});
    }

    /// The same series as those of the libraries' adaptive methods.
    void enter_tolerances(const std::string& id) {
        RunDescription run = run_over(plan_.study, id, Precision::double_, 1);
        for (double tolerance = 0.3; tolerance > 1e-16; tolerance *= plan_.tolerance_ratio) {
            run.method_parameters.set("tolerance", tolerance);
            Measurement measured = measure(run, 1, reference_);
            measured.wall_seconds = stepping_seconds(run, 1);
            enter(measured);
            if (*measured.wall_seconds > plan_.study.most_seconds_a_run) return;
        }
    }

    /// A series from loose to tight, until a run is too long or many gain nothing.
    void enter(const Solver& solver, int group) {
        double best_error = 1e300;
        int useless = 0;
        const double ratio = solver.adaptive ? plan_.tolerance_ratio : plan_.study.ratio;
        for (double setting = solver.adaptive ? 1 : 4; useless < plan_.patience; setting *= ratio) {
            if (setting < 1e-17 || setting > 1e8) return;
            if (!solver.adaptive) setting = std::ceil(setting);
            std::vector<Vec3> end;
            double seconds = 0, error = 1e300;
            try {
                seconds = seconds_of([&] { end = solver.solve(setting); });
                error = error_of(end, plan_, reference_);
            } catch (const std::exception&) {  // the library gave up
            }
            useless = best_error < converging && error > 0.8 * best_error ? useless + 1 : 0;
            best_error = std::min(best_error, error);
            entries_.push_back({fmt::format("{} {:.0e}", solver.name, setting), group, error,
                                [solver, setting] { return seconds_of([&] { solver.solve(setting); }); }, seconds});
            if (seconds > plan_.study.most_seconds_a_run) return;
        }
    }

    /// Keeps what may be the fastest of its group at a target: within a factor 2 of the first timing.
    void drop_hopeless() {
        std::vector<const Entry*> kept;
        if (plan_.smallest) {
            for (const char* program : programs) kept.push_back(most_exact(program));
        }
        const auto hopeless = [&](const Entry& entry) {
            return std::none_of(plan_.targets.begin(), plan_.targets.end(), [&](double target) {
                const Entry* fastest = best(entry.group, target);
                return fastest && entry.error <= target && entry.least <= 2 * fastest->least;
            });
        };
        std::vector<Entry> left;
        for (const Entry& entry : entries_) {
            if (!hopeless(entry) || std::find(kept.begin(), kept.end(), &entry) != kept.end()) left.push_back(entry);
        }
        entries_ = std::move(left);
    }

    const Entry* best(int group, double target) const {
        const Entry* best = nullptr;
        for (const Entry& entry : entries_) {
            if (entry.group == group && entry.error <= target && (!best || entry.least < best->least)) best = &entry;
        }
        return best;
    }

    /// The run of the smallest error, with either force.
    const Entry* most_exact(std::string_view program) const {
        const Entry* most = nullptr;
        for (const Entry& entry : entries_) {
            const bool theirs = entry.group == 0 ? program == programs[0] : entry.who.starts_with(program);
            if (theirs && (!most || entry.error < most->error)) most = &entry;
        }
        return most;
    }

    static std::string cell(const Entry* entry, std::size_t width) {
        if (!entry) return fmt::format("{:>10}  {:<{}}", "-", "", width);
        return fmt::format("{:>7.1f} µs  {:<{}}", entry->least * 1e6, entry->who, width);
    }
    static std::string cell(const Entry* theirs, const Entry* own, std::size_t width) {
        if (!theirs) return fmt::format("{:>10} {:>6}  {:<{}}", "-", "", "", width);
        return fmt::format("{:>7.1f} µs {:>6.2f}  {:<{}}", theirs->least * 1e6, own ? theirs->least / own->least : 0.0,
                           theirs->who, width);
    }

    ContestPlan plan_;
    Reference reference_;
    std::vector<Entry> entries_;
};

}  // namespace steplab::benchmark

int main(int argc, char** argv) {
    using namespace steplab::benchmark;
    std::vector<std::string> words(argv + 1, argv + argc), scenes;
    const bool in_lines = wants_lines(words);
    int rounds = 0;
    for (const std::string& word : words) {
        const int number = std::atoi(word.c_str());
        if (number > 0) {
            rounds = number;
        } else {
            scenes.emplace_back(word);
        }
    }
    if (scenes.empty()) scenes = {"chain", "morse", "mesh"};
    const steplab::FlushSubnormals flush;  // for the libraries too
    for (const std::string& scene : scenes) {
        const ContestPlan plan = contest_plan(scene);
        Contest contest(plan);
        contest.hold(rounds > 0 ? rounds : plan.rounds);
        in_lines ? contest.print_lines() : contest.print_table();
    }
}
