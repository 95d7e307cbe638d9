#pragma once

#include "lab/study/speed_error.hpp"
#include "solver.hpp"

#include <string_view>
#include <vector>

namespace steplab::benchmark {

/// What is computed in a contest, how well, and how closely its settings lie.
struct ContestPlan {
    std::string_view name;
    StudyPlan study;
    double length = 1;  ///< errors are distances at the end divided by it
    std::vector<double> targets{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
    double tolerance_ratio = 0.6;       ///< of neighbouring settings; of numbers of steps: the ratio of the study
    std::size_t most_steps = 10000000;  ///< of a library's run
    int patience = 20;                  ///< settings in a row that may gain nothing before a series ends
    int rounds = 20;                    ///< in which runs are timed
    bool smallest = false;              ///< whether the smallest error that each program reaches is of interest, too
};

/// Of chain, morse, mesh, kepler or outer-solar-system. Throws UsageError for others.
ContestPlan contest_plan(std::string_view name);

/// What libraries are given: what moves, at the start.
Problem problem_of(const ContestPlan& plan);

/// Largest distance of a particle from the reference, by the plan's length. `end`: of the problem's particles.
double error_of(const std::vector<Vec3>& end, const ContestPlan& plan, const Reference& reference);

}  // namespace steplab::benchmark
