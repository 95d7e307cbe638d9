#pragma once

#include "session/session_view.hpp"

#include <string>

namespace steplab::ui {

/// What the lamp below the slider of dt says; none: nothing is known.
enum class Lamp {
    none,
    good,
    caution,  ///< stable, but with too few steps, close to the limit, or ruled by rounding
    bad
};

/// How the dt of a run stands to the stability limit.
struct StepVerdict {
    Lamp lamp = Lamp::none;
    std::string text;
    std::string detail;  ///< how the steps treat the fastest oscillation; empty if there is none
    std::string tooltip;
};
/// By the scene as it is now, or as it is at rest where `present` is null.
StepVerdict step_verdict(const RunView& view, const PresentLimit* present = nullptr);
/// One whose texts need as much room as any, where the steps are as long as dt says.
const StepVerdict& longest_verdict();

}  // namespace steplab::ui
