#pragma once

#include "sim/run/run_description.hpp"

#include <string_view>

namespace steplab::test {

/// The description with another value of dt or of a parameter of its scene.
inline RunDescription with(RunDescription run, std::string_view name, double value) {
    if (name == "dt") {
        run.dt = value;
    } else {
        run.scene.set(name, value);
    }
    return run;
}

}  // namespace steplab::test
