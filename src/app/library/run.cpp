#include "app/library/implementation.hpp"
#include "core/duration.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/recorded_run.hpp"
#include "session/played_frames.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace steplab::library {

namespace {

/// Up to this number every integer is exactly a double.
constexpr std::uint64_t most_steps = 9007199254740992;
constexpr std::uint64_t usual_steps = 1000;

RunEnd end_at(const RunDescription& run, double until) {
    if (!std::isfinite(until)) throw steplab::UsageError("the end time must be finite");
    if (until / run.dt < 0)
        throw steplab::UsageError(
            fmt::format("until = {} and dt = {} differ in sign: a negative dt goes with a negative end time",
                        exact_text(until), exact_text(run.dt)));
    if (until / run.dt > static_cast<double>(most_steps))
        throw steplab::UsageError(fmt::format("until = {} needs more than {} steps of dt {}", exact_text(until),
                                              most_steps, exact_text(run.dt)));
    return run_end(run, until);
}

RunEnd end_of(const RunDescription& run, const End& end) {
    if (end.steps && end.until)
        throw steplab::UsageError("steps and until both set the length of the run: give only one of them");
    if (end.steps && *end.steps > most_steps)
        throw steplab::UsageError(fmt::format("steps must be at most {} (got {})", most_steps, *end.steps));
    if (end.steps) return {*end.steps};
    const std::optional<double> until = end.until ? end.until : model_of(run).opening.until;
    return until ? end_at(run, *until) : RunEnd{usual_steps};
}

void append(std::vector<double>& to, std::span<const Vec3> vectors) {
    const auto from = numbers(vectors);
    to.insert(to.end(), from.begin(), from.end());
}

void append_frames(PlayedFrames& frames, std::uint64_t first, std::uint64_t every, Recording& rows) {
    const std::uint64_t count = first < frames.frames() ? (frames.frames() - first - 1) / every + 1 : 0;
    const auto particles = static_cast<double>(frames.rows());
    check_memory(static_cast<double>(count) * (16 + 2 * static_cast<double>(sizeof(Vec3)) * particles),
                 fmt::format("{} rows of {} particles", count, frames.rows()), "read fewer frames (first, every)");
    Frame frame;
    for (std::uint64_t number = first; number < frames.frames(); number += every) {
        check_interruption();
        frames.frame(number, frame);
        rows.steps.push_back(frame.step);
        rows.times.push_back(frame.time);
        append(rows.positions, frame.positions);
        append(rows.velocities, frame.velocities);
    }
}

/// In a row of n particles.
double bytes_of_row(std::size_t particles, const Recorded& wanted) {
    constexpr double step_time_energies = sizeof(std::uint64_t) + 5 * sizeof(double);
    const int vectors = int{wanted.positions} + int{wanted.velocities};
    return step_time_energies + static_cast<double>(sizeof(Vec3)) * vectors * static_cast<double>(particles);
}

/// Rows of a run, one after the other. Their memory is taken at once: vectors that grow take up to three times as much.
class Recorder {
public:
    Recorder(Recording& rows, const Recorded& wanted, std::uint64_t count) : rows_(rows), wanted_(wanted) {
        const double bytes = static_cast<double>(count) * bytes_of_row(rows.particles, wanted);
        check_memory(bytes, fmt::format("{} rows of {} particles", count, rows.particles),
                     "record fewer steps (every), or no positions or velocities");
        rows.steps.reserve(count);
        for (auto* numbers : {&rows.times, &rows.kinetic, &rows.potential, &rows.energy, &rows.energy_error})
            numbers->reserve(count);
        if (wanted.positions) rows.positions.reserve(3 * rows.particles * count);
        if (wanted.velocities) rows.velocities.reserve(3 * rows.particles * count);
    }

    void add(const steplab::Simulation& run) {
        rows_.steps.push_back(run.step());
        rows_.times.push_back(run.time());
        const Diagnostics now = run.diagnostics();
        rows_.kinetic.push_back(now.kinetic);
        rows_.potential.push_back(now.potential);
        rows_.energy.push_back(now.energy);
        rows_.energy_error.push_back(now.energy_error);
        if (!wanted_.positions && !wanted_.velocities) return;
        run.frame(frame_, {.positions = wanted_.positions});
        if (wanted_.positions) append(rows_.positions, frame_.positions);
        if (wanted_.velocities) append(rows_.velocities, frame_.velocities);
    }

private:
    Recording& rows_;
    Recorded wanted_;
    Frame frame_;
};

void fill(Result& result, const RunSummary& summary) {
    result.method = summary.run.method;
    result.precision = id(summary.run.precision);
    result.dt = summary.result.dt;
    result.evaluations = summary.result.evaluations;
    result.status = summary.result.status();
    if (summary.result.divergence) result.reason = summary.result.divergence->message;
    result.hash = summary.result.hash;
    result.notes = summary.notes;
    result.error = summary.result.error;
    result.wall_seconds = summary.wall_seconds;
}

}  // namespace

RunDescription described(const Scene& scene, const Settings& settings) {
    RunDescription run = run_of(scene);
    if (!settings.method.empty()) run = with_method(std::move(run), settings.method);
    if (settings.dt) run.dt = *settings.dt;
    run.precision = precision_named(settings.precision, run);
    for (const auto& [name, value] : settings.parameters) {
        if (run.scene.contains(name))
            throw steplab::UsageError(fmt::format("'{}' is a parameter of the scene: give it to the scene", name));
        set_parameter(run, name, value.text());
    }
    check(run);
    return run;
}

Precision precision_named(const std::string& name, const RunDescription& run) {
    if (name.empty()) return run.precision;
    if (const auto precision = parse_precision(name)) return *precision;
    constexpr std::array known{id(Precision::float_), id(Precision::double_)};
    throw steplab::UsageError(unknown_word("precision", name, known));
}

Parameters parameters_of(const ParameterValues& values) {
    Parameters parameters;
    for (const ParameterInfo& info : values.infos())
        parameters.emplace(info.name, Value(format_value(info, values[info.name])));
    return parameters;
}

std::span<const double> numbers(std::span<const Vec3> vectors) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return {reinterpret_cast<const double*>(vectors.data()), 3 * vectors.size()};
}

std::vector<Vec3> vectors(std::span<const double> numbers, std::size_t particles, std::string_view what) {
    if (numbers.size() != 3 * particles)
        throw steplab::UsageError(
            fmt::format("{}: {} numbers, but {} particles have {}", what, numbers.size(), particles, 3 * particles));
    std::vector<Vec3> vectors(particles);
    for (std::size_t i = 0; i < particles; ++i) {
        const auto one = numbers.subspan(3 * i, 3);
        if (!std::all_of(one.begin(), one.end(), [](double number) { return std::isfinite(number); }))
            throw steplab::UsageError(
                fmt::format("{} of particle {} are not finite: {}, {}, {}", what, i, one[0], one[1], one[2]));
        vectors[i] = {one[0], one[1], one[2]};
    }
    return vectors;
}

void check_memory(double bytes, std::string_view what, std::string_view instead) {
    if (bytes < 1e6) return;  // always there, and to ask the system takes longer than a short run
    const double there = available_memory();
    if (bytes > there)
        throw steplab::UsageError(fmt::format("{} need {} of memory, {} are available: {}", what, bytes_text(bytes),
                                              bytes_text(there), instead));
}

void Result::check() const {
    if (status != "ok") throw Diverged(reason);
}

Result run(const Scene& scene, const Settings& settings, const End& end, const Recorded& recorded) {
    return translated([&] {
        const RunDescription description = described(scene, settings);
        const RunEnd last = end_of(description, end);
        const std::uint64_t every = recorded.every > 0 ? recorded.every : std::max<std::uint64_t>(1, last.step);
        steplab::Simulation simulation(description, {.threads = settings.threads});
        simulation.count_drag_work();
        Result result;
        result.rows.particles = simulation.particles();
        const std::uint64_t recorded_steps = last.step / every + (last.step % every == 0 ? 0 : 1);
        Recorder recorder(result.rows, recorded, 1 + recorded_steps);
        fill(result, record_run(
                         simulation, last, every, [](std::uint64_t) {},
                         [&](const steplab::Simulation& now) { recorder.add(now); }));
        return result;
    });
}

Trajectory read(const std::string& file, std::uint64_t first, std::uint64_t every) {
    return translated([&] {
        if (every == 0) throw steplab::UsageError("every must be 1 or more");
        const auto frames = played_frames(file);
        for (; frames->has_more(); frames->look_on()) check_interruption();
        Trajectory trajectory;
        trajectory.rows.particles = static_cast<std::size_t>(frames->rows());
        if (const auto run = frames->run()) trajectory.run = command_line(*run);
        trajectory.fault = frames->fault();
        try {
            append_frames(*frames, first, every, trajectory.rows);
        } catch (const steplab::FileError& error) {  // in a row of particles
            trajectory.fault = error.what();
        }
        trajectory.complete = trajectory.fault.empty();
        return trajectory;
    });
}

}  // namespace steplab::library
