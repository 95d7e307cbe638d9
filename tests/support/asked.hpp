#pragma once

#include "core/error.hpp"
#include "sim/run/run_description.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace steplab::test {

/// What the project asks of an error of methods that choose their own steps: 1000 tolerances, no less than 1e-9.
inline double asked_error(double tolerance) { return std::max(1000 * tolerance, 1e-9); }

/// What a run is refused for; none if it is not.
inline std::optional<std::string> refusal_of(const RunDescription& run) {
    try {
        check(run);
        return std::nullopt;
    } catch (const UsageError& error) {
        return error.what();
    }
}

}  // namespace steplab::test
