#pragma once

#include "render/palette.hpp"
#include "render/shown_runs.hpp"
#include "render/sketch.hpp"
#include "render/style.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab::render {

/// A line of text about the runs of a picture.
struct RunLine {
    std::string text;
    std::optional<std::size_t> run = {};  ///< whose mark stands before it
};

/// Which run has which mark, and how many times the differences of ghosts are magnified, if they are.
std::vector<RunLine> lines_of_ghosts(ShownRuns runs, const Style& style);
/// The name of a run, after its mark and its number.
RunLine line_of_run(const ShownRun& run, std::size_t number);

/// The right end of a picture at which lines stand.
enum class RunLinesAt : std::uint8_t { top, foot };

/// Adds the lines to a picture, and returns the height that they take at its top.
double sketch_run_lines(Sketch& sketch, const std::vector<RunLine>& lines, RunLinesAt place, PictureSize size,
                        const Palette& palette, double pixel_scale);

}  // namespace steplab::render
