#pragma once

#include "sim/run/run_description.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// A number that differs from run to run of an ensemble: dt, or a parameter of the model or the method.
struct ParameterRange {
    std::string name;
    double from = 0, to = 0;

    /// The value of run i: from + (to - from) i / (runs - 1), computed in double from left to right; the last run has
    /// `to` itself, a single one `from`.
    double value(std::size_t run, std::size_t runs) const;
    friend bool operator==(const ParameterRange&, const ParameterRange&) = default;
};

/// "k=1:2". Throws UsageError for what is not of that form, names neither dt nor a parameter whose values are numbers,
/// or goes beyond its range.
ParameterRange parse_parameter_range(const RunDescription& description, const std::string& text);

/// The description with each spread's value of run i. Throws UsageError if that is not possible, such as half a
/// particle.
RunDescription run_in_range(RunDescription description, std::span<const ParameterRange> ranges, std::size_t run,
                            std::size_t runs);

}  // namespace steplab
