#pragma once

#include "lab/study/study.hpp"

#include <string>
#include <utility>
#include <vector>

namespace steplab::test {

/// A chain over a short time, in double, with runs short enough for a test. A series is ended by the number of steps,
/// not by time, so that other load of the machine has no effect.
inline StudyPlan small_plan(std::vector<std::string> methods) {
    StudyPlan plan{.scene = describe("chain", "rk4"),
                   .time = 5,
                   .methods = std::move(methods),
                   .method_settings = {},
                   .precisions = {Precision::double_}};
    plan.most_seconds_a_run = 60;
    plan.most_steps_a_run = 5000;
    plan.rounds = 1;
    return plan;
}

inline Measurement run_with(const char* method, double dt, double error, double seconds) {
    Measurement m{.run = describe("chain", method), .steps = 10, .wall_seconds = seconds};
    m.run.dt = dt;
    m.result.hash = "0123456789abcdef";
    m.result.evaluations = 40;
    m.error = error;
    m.rms_error = error / 2;
    m.result.energy_error = error / 3;
    return m;
}

/// A run that blew up within a short time.
inline Measurement diverged(const char* method, double seconds) {
    Measurement m = run_with(method, 5, 0, seconds);
    m.result.divergence.emplace();
    return m;
}

inline const auto no_progress = [](double) {};

}  // namespace steplab::test
