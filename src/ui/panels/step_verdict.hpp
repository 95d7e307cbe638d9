#pragma once

#include "session/run_view.hpp"

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
    std::string tooltip;
};
StepVerdict step_verdict(const RunView& view);

}  // namespace steplab::ui
