#pragma once

#include "lab/report/figure.hpp"
#include "lab/report/table.hpp"

#include <vector>

namespace steplab {

// The tables and charts of the thesis the project grew out of (A. Sosnowski, UMK Toruń, 2008), recomputed from runs
// beside the published figures. docs/thesis.md explains the differences.

/// Position of the tenth particle of a chain after 681 steps of 0.1 (L = 3, v0 = 1).
Table thesis_table_1();
/// Largest dt of a grid of 0.1 at which 1000 steps stay within twenty times the exact amplitude (leave the picture, by
/// eye), for one and for ten points: of the right formulas and of those printed, beside the limits of theory.
Table thesis_table_2();
/// Milliseconds for 1000 steps of 0.1 of ten points. Measured: differs from machine to machine.
Table thesis_table_3();
/// Simulated time that 1000 steps reach at each method's largest dt, and what a simulated second costs there. Measured.
Table thesis_table_4();

/// Its charts: an oscillator with its exact motion; the tenth particle at dt = 0.1, 0.5 and 0.9; Morse potential and
/// force for D = 1, k = 1, r0 = 2.
struct ThesisChart {
    std::string title;
    Figure figure;
};
std::vector<ThesisChart> thesis_charts();

/// All of it as one page that needs nothing else.
std::string thesis_page();

}  // namespace steplab
