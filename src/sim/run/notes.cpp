#include "sim/run/notes.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace steplab {
namespace {

double rounding_unit(Precision precision) {
    return precision == Precision::float_ ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                          : std::numeric_limits<double>::epsilon();
}

/// The largest angular frequency; of pairs, for which none is known, that of one alone.
double fastest(const RunDescription& run, const std::optional<StabilityLimit>& limit) {
    return limit ? limit->omega_max : fastest_frequency(run);
}

/// A step moves a particle by about ω dt of its displacement. With less than these units of rounding, an increment
/// keeps fewer than 7 binary digits, and what is lost has a sign of its own.
constexpr double units_of_an_increment = 128;

std::optional<std::string> note_of_increments(const RunDescription& run, double omega) {
    const bool compensated = run.method_parameters.contains("compensated") && run.method_parameters["compensated"] > 0;
    const bool kept = compensated || chooses_its_steps(run) || !(omega > 0);
    if (kept || std::abs(run.dt) * omega >= units_of_an_increment * rounding_unit(run.precision)) return std::nullopt;
    const std::string remedy = run.method_parameters.contains("compensated") ? ", compensated=1 keeps it" : "";
    return fmt::format(
        "a step of dt = {} s adds so little that {} rounds most of it away: a larger dt is more accurate{}",
        typed(run.dt), id(run.precision), remedy);
}

/// Of a bond, what must be resolved.
constexpr double resolved_part = 1e-3;

std::optional<std::string> note_of_distance(const RunDescription& run, double farthest) {
    const double bond = facts_of(run).bond;
    const double resolved = farthest * rounding_unit(run.precision);
    if (!(bond > 0) || !(resolved > resolved_part * bond)) return std::nullopt;
    return fmt::format("a displacement of {} m is known to {} m in {}, which is too little for bonds of {} m",
                       typed(farthest), typed(resolved), id(run.precision), typed(bond));
}

}  // namespace

std::vector<std::string> notes_of_rounding(const RunDescription& run, const std::optional<StabilityLimit>& limit,
                                           double farthest) {
    std::vector<std::string> notes;
    if (auto note = note_of_increments(run, fastest(run, limit))) notes.push_back(std::move(*note));
    if (auto note = note_of_distance(run, farthest)) notes.push_back(std::move(*note));
    return notes;
}

}  // namespace steplab
