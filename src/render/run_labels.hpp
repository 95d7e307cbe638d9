#pragma once

#include "render/palette.hpp"
#include "render/shown_runs.hpp"
#include "render/sketch.hpp"
#include "render/split.hpp"
#include "render/style.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace steplab::render {

/// A line of text about the runs of a picture.
struct RunLine {
    std::string text;
    /// What stands before it.
    struct Run {
        std::size_t number = 0;  ///< 0: the leading one, whose mark is filled
        std::size_t swatch = 0;
    };
    std::optional<Run> run = {};
};

/// Which run has which mark, of several in one picture, and how many times the differences of ghosts and the
/// displacements are magnified, if they are.
std::vector<RunLine> lines_of_runs(ShownRuns runs, const Style& style);
/// The same of a run in a tile of its own.
std::vector<RunLine> lines_of_tile(const ShownRun& run, std::size_t number);
/// How many lines a picture of so many runs, or each tile of it, has at most.
std::size_t most_run_lines(std::size_t runs, const Style& style);
/// The name of a run, after its mark and its number.
RunLine line_of_run(const ShownRun& run, std::size_t number);

/// The part of a run's picture that lines about runs keep to, longer ones being cut off at their end: at its upper
/// right, or, beside the cross of the axes, at its foot, where the picture is too narrow for the window's read-out
/// beside them or shows one of several runs.
PictureArea run_lines_area(PictureSize picture, RunLayout layout, std::size_t lines, double pixel_scale);
/// Units of the layout from the left of a picture that the window's read-out keeps to, beside lines at the top.
inline constexpr double read_out_room = 430;

/// Adds the lines, and returns what of the area they take.
PictureArea sketch_run_lines(Sketch& sketch, const std::vector<RunLine>& lines, const PictureArea& area,
                             const Palette& palette, double pixel_scale);

}  // namespace steplab::render
