#include "sim/run/notes.hpp"

#include "core/number_text.hpp"
#include "methods/engines/adaptive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace steplab {
namespace {

double rounding_unit(Precision precision) {
    return precision == Precision::float_ ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                          : std::numeric_limits<double>::epsilon();
}

/// A step moves a particle by about ω dt of its displacement. With less than these units of rounding, an increment
/// keeps fewer than 7 binary digits, and what is lost has a sign of its own.
constexpr double units_of_an_increment = 128;

using Rate = std::function<double(double)>;

/// The largest frequency, which may take long to find, is asked for only where that of a pair alone, which is lower,
/// does not answer.
double rate_of(const RunDescription& run, const Rate& rate, double enough) {
    const double omega = fastest_frequency(run);
    return omega > 0 || !rate ? omega : rate(enough);
}

std::optional<std::string> note_of_increments(const RunDescription& run, const Rate& rate) {
    const bool compensated = run.method_parameters.contains("compensated") && run.method_parameters["compensated"] > 0;
    if (compensated || chooses_its_steps(run)) return std::nullopt;
    const double enough = units_of_an_increment * rounding_unit(run.precision) / std::abs(run.dt);
    if (facts_of(run).pair_frequency >= enough) return std::nullopt;
    const double omega = rate_of(run, rate, enough);
    if (!(omega > 0) || omega >= enough) return std::nullopt;
    const std::string remedy = run.method_parameters.contains("compensated") ? ", compensated=1 keeps it" : "";
    return fmt::format(
        "a step of dt = {} s adds so little that {} rounds most of it away: a larger dt is more accurate{}",
        typed(run.dt), id(run.precision), remedy);
}

/// Of a bond, what must be resolved.
constexpr double resolved_part = 1e-3;

std::optional<std::string> note_of_distance(const RunDescription& run, double farthest) {
    const SceneFacts facts = facts_of(run);
    const double resolved = farthest * rounding_unit(run.precision);
    if (!(facts.bond > 0) || !(resolved > resolved_part * std::min(facts.bond, facts.bond_width))) return std::nullopt;
    const std::string bonds = facts.bond_width < facts.bond
                                  ? fmt::format("bonds whose force changes within {} m", typed(facts.bond_width))
                                  : fmt::format("bonds of {} m", typed(facts.bond));
    return fmt::format("a displacement of {} m is known to {} m in {}, which is too little for {}", typed(farthest),
                       typed(resolved), id(run.precision), bonds);
}

std::optional<std::string> note_of_tolerance(const RunDescription& run) {
    if (!chooses_its_steps(run)) return std::nullopt;
    const double tolerance = run.method_parameters["tolerance"], held = rounding_unit(run.precision);
    // one that was not asked for is none to be missed
    if (!(tolerance < held) || tolerance == tolerance_parameter.default_value) return std::nullopt;
    return fmt::format("a tolerance of {} is less than {} holds, which is {}: it is not met", typed(tolerance),
                       id(run.precision), typed(held));
}

NotesOfRuns::ByKind notes_by_kind(const RunDescription& run, double farthest, const Rate& rate) {
    return {note_of_increments(run, rate), note_of_distance(run, farthest), note_of_tolerance(run)};
}

}  // namespace

std::vector<std::string> notes_of_rounding(const RunDescription& run, double farthest, const Rate& rate) {
    std::vector<std::string> notes;
    for (auto& note : notes_by_kind(run, farthest, rate)) {
        if (note) notes.push_back(std::move(*note));
    }
    return notes;
}

std::vector<std::string> notes_of_rounding(const Simulation& simulation) {
    if (simulation.divergence()) return {};
    return notes_of_rounding(simulation.description(), simulation.farthest(),
                             [&](double enough) { return simulation.rate_of_motion(enough); });
}

void NotesOfRuns::add(const RunDescription& run, double farthest) {
    const auto notes = notes_by_kind(run, farthest, nullptr);
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (!notes[i]) continue;
        if (kinds_[i].runs++ == 0) kinds_[i] = {1, runs_, *notes[i]};
    }
    ++runs_;
}

std::vector<std::string> NotesOfRuns::all() const {
    std::vector<std::string> all;
    for (const Kind& kind : kinds_) {
        if (kind.runs > 0)
            all.push_back(
                fmt::format("{} of {} runs, the first of them run {}: {}", kind.runs, runs_, kind.first, kind.text));
    }
    return all;
}

}  // namespace steplab
