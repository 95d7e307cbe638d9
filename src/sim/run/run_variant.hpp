#pragma once

#include "sim/run/run_description.hpp"

#include <string>
#include <string_view>

namespace steplab {

/// The run with what the text says in place of its own: "method=rk4,dt=0.02,precision=float,tolerance=1e-9", any of
/// them, parameters of the scene too. Parameters of another method start at their defaults. Throws UsageError for a
/// text of another form; whether the run is possible is left to check().
RunDescription variant_of(const RunDescription& run, std::string_view text);

/// "method=rk4,dt=0.02,precision=float", the parameters of the method that are not at their defaults and those of the
/// scene that differ from `of`: variant_of(of, text) is the run.
std::string variant_text(const RunDescription& run, const RunDescription& of);

}  // namespace steplab
