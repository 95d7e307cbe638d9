#pragma once

#include "core/entry.hpp"
#include "session/run_view.hpp"
#include "sim/run/run_description.hpp"

#include <string>

namespace steplab::ui {

/// "order 4 · 4 force evaluations per step · symplectic · conserves momentum": a method with these parameters on a
/// scene. What the scene does not let it conserve is named with the cause: "momentum changes in this scene (a fixed
/// particle)".
std::string method_text(const MethodInfo& info, const ParameterValues& parameters, const SceneFacts& scene,
                        const Conservation& kept);

}  // namespace steplab::ui
