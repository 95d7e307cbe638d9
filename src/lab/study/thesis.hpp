#pragma once

#include "lab/report/table.hpp"
#include "plot/plot.hpp"

#include <vector>

namespace steplab {

// The tables and charts of the thesis from which the project originated (A. Sosnowski, UMK Toruń, 2008), recomputed and
// compared with the published values. docs/thesis.md explains the differences.

/// Position of the tenth particle of a chain after 681 steps of 0.1 (L = 3, v0 = 1).
Table thesis_table_1();
/// Largest multiple of 0.1 s for dt at which 1000 steps stay within twenty times the exact amplitude ("by eye"), for
/// one and for ten points: of the correct formulas and of those printed, with the limits of linear theory.
Table thesis_table_2();
/// Milliseconds for 1000 steps of ten points. Measured: depends on the machine.
Table thesis_table_3();
/// Simulated time of 1000 steps at each method's largest dt, and the cost of a simulated second. Measured.
Table thesis_table_4();

/// The charts: an oscillator with its exact motion; the tenth particle at dt = 0.1, 0.5 and 0.9; Morse potential and
/// force for D = 1, k = 1, r0 = 2.
struct ThesisChart {
    std::string title;
    plot::Plot figure;
};
std::vector<ThesisChart> thesis_charts();

/// All of it as one self-contained page.
std::string thesis_page();

}  // namespace steplab
