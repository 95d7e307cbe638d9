#pragma once

#include "sim/run/run_description.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// A number that differs from run to run of an ensemble: dt, or a parameter of the model or the method.
struct Spread {
    std::string name;
    double from = 0, to = 0;

    /// Of run i of so many: from + (to - from) i / (runs - 1), computed in double from left to right; the last run has
    /// `to` itself, a single one `from`.
    double value(std::size_t run, std::size_t runs) const;
};

/// "k=1:2". Throws UsageError for what is not of that form, names neither dt nor a parameter whose values are numbers,
/// or goes beyond its range.
Spread parse_spread(const RunDescription& description, const std::string& text);

/// The description with each spread's value of run i. Throws UsageError if that is not possible, such as half a
/// particle.
RunDescription spread_run(RunDescription description, std::span<const Spread> spreads, std::size_t run,
                          std::size_t runs);

}  // namespace steplab
