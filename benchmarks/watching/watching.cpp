// What handing its moments over costs a run: steps a second of a mesh that plays as fast as it can while a window takes
// every new view sixty times a second, beside the same steps taken with nobody watching. As a shared machine is not as
// fast in one round as in the next, the part of a watched run's own time that is not spent in steps is told too.
//
//     watching [--lines] [ROUNDS [PRECISION [DIM...]]]
//         rounds of two seconds each way (default 5), medians are told; meshes of DIM x DIM (default 100, 316, 1000);
//         with --lines in lines for benchmarks/results: ns a step of the watched run, and of its steps alone

#include "lines.hpp"
#include "session/worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace steplab;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::duration<double> round_time{2.0};
constexpr std::chrono::microseconds frame_time{16667};

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

struct Watched {
    double steps_per_second = 0;
    double views_per_second = 0;
    double beside_steps = 0;  ///< part of the time
};

/// A run with a window that looks at it.
class Watching {
public:
    explicit Watching(const RunDescription& description) : worker_(description) {
        worker_.send(event::SetRate{{true, 1}});
    }

    Watched measure() {
        worker_.send(event::Play{true});
        while (!take() || !view_.playing) std::this_thread::sleep_for(frame_time);
        const auto begin = Clock::now();
        const std::uint64_t first = view_.frame.step;
        int views = 0;
        double stepping = 0;  // seconds of the steps and their checks alone, by the speed that each view tells
        // The last view may be a while old: the time counts until it came.
        double seconds = 0;
        std::uint64_t last = first;
        while (seconds_since(begin) < round_time.count() || views == 0) {
            std::this_thread::sleep_for(frame_time);
            if (!take()) continue;
            ++views;
            seconds = seconds_since(begin);
            const double speed = view_.steps_per_second.value_or(0);
            if (speed > 0) stepping += static_cast<double>(view_.frame.step - last) / speed;
            last = view_.frame.step;
        }
        const double steps = static_cast<double>(view_.frame.step - first);
        worker_.send(event::Play{false});
        while (!take() || view_.playing) std::this_thread::sleep_for(frame_time);
        return {steps / seconds, views / seconds, 1 - stepping / seconds};
    }

private:
    bool take() { return worker_.take(session_); }

    Worker worker_;
    SessionView session_;
    RunView& view_ = session_.leading;
};

/// Steps a second in portions as a worker takes them.
double alone(Simulation& simulation) {
    std::uint64_t portion = 1, steps = 0;
    const auto begin = Clock::now();
    while (seconds_since(begin) < round_time.count()) {
        const auto portion_begin = Clock::now();
        simulation.advance(portion);
        steps += portion;
        if (seconds_since(portion_begin) < 0.004) portion *= 2;
    }
    return static_cast<double>(steps) / seconds_since(begin);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Medians of some rounds.
struct Cost {
    std::size_t particles = 0;
    double alone = 0, watched = 0;              ///< steps a second
    double views = 0;                           ///< a second
    double by_the_clock = 0, beside_steps = 0;  ///< parts of the time
};

Cost measure(const RunDescription& description, int rounds) {
    Simulation simulation(description);
    Watching watching(description);
    std::vector<double> by_itself, watched, views, cost, beside;
    for (int i = 0; i < rounds; ++i) {
        by_itself.push_back(alone(simulation));
        const Watched now = watching.measure();
        watched.push_back(now.steps_per_second);
        views.push_back(now.views_per_second);
        beside.push_back(now.beside_steps);
        cost.push_back(1 - watched.back() / by_itself.back());
    }
    return {simulation.particles(), median(by_itself), median(watched), median(views), median(cost), median(beside)};
}

void print(const Cost& cost) {
    fmt::print(
        "{:8} particles  alone {:9.1f} steps/s  watched {:9.1f} steps/s  {:5.1f} views/s  cost {:5.1f} %  "
        "beside its steps {:4.1f} %\n",
        cost.particles, cost.alone, cost.watched, cost.views, 100 * cost.by_the_clock, 100 * cost.beside_steps);
}

void print_lines(const Cost& cost, Precision precision) {
    const std::string row = fmt::format("watching-{}", cost.particles);
    const double particles = static_cast<double>(cost.particles), ns = 1e9 / cost.watched;
    benchmark::print({row, "velocity-verlet", id(precision), particles, "steplab watched", ns});
    benchmark::print({row, "velocity-verlet", id(precision), particles, "steplab", ns * (1 - cost.beside_steps)});
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool in_lines = benchmark::wants_lines(words);
    const int rounds = words.empty() ? 5 : std::max(1, std::atoi(words[0].c_str()));
    RunDescription description = describe("mesh", "velocity-verlet");
    if (words.size() > 1) description.precision = words[1] == "float" ? Precision::float_ : Precision::double_;
    std::vector<double> dims{100, 316, 1000};
    if (words.size() > 2) dims.clear();
    for (std::size_t i = 2; i < words.size(); ++i) dims.push_back(std::atof(words[i].c_str()));
    for (const double dim : dims) {
        description.scene.set("dim", dim);
        const Cost cost = measure(description, rounds);
        in_lines ? print_lines(cost, description.precision) : print(cost);
    }
}
