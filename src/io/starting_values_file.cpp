#include "io/starting_values_file.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "io/trajectory_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace steplab {

namespace {

const Columns all_columns{Column::x,  Column::y,  Column::z,  Column::vx, Column::vy,
                          Column::vz, Column::ux, Column::uy, Column::uz};

[[noreturn]] void refuse_step(const std::string& name, std::optional<std::uint64_t> step) {
    const std::string what = step ? fmt::format("it has no frame of step {}", *step) : "it holds no frame";
    throw FileError(fmt::format("cannot read '{}': {}", shown(name), what));
}

/// The number of the frame of this step; steps ascend.
std::uint64_t frame_of(TrajectoryReader& reader, const std::string& name, std::uint64_t step) {
    Frame frame;
    std::uint64_t first = 0, end = reader.frames();
    while (first < end) {
        const std::uint64_t middle = first + (end - first) / 2;
        reader.frame(middle, frame);
        if (frame.step == step) return middle;
        if (frame.step < step) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    refuse_step(name, step);
}

StartingValues values_of(TrajectoryReader reader, const std::string& name, std::optional<std::uint64_t> step) {
    if (reader.frames() == 0) refuse_step(name, step);
    Frame frame;
    reader.frame(step ? frame_of(reader, name, *step) : reader.frames() - 1, frame);
    return {.given = {},
            .positions = std::move(frame.positions),
            .velocities = std::move(frame.velocities),
            .displacements = std::move(frame.displacements)};
}

/// Rows are the particles of a scene in their order.
void check_rows(const FrameBlock& frame, const std::string& name) {
    for (std::size_t row = 0; row < frame.particles.size(); ++row) {
        if (frame.particles[row] != row)
            throw FileError(
                fmt::format("cannot read '{}': particle {} is missing: a start needs all of them", shown(name), row));
    }
}

}  // namespace

FileAtStep file_at_step(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) return {text};
    std::uint64_t step = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + colon + 1, end, step);
    if (read.ec != std::errc{} || read.ptr != end) return {text};
    return {text.substr(0, colon), step};
}

StartingValues starting_values(InputFile file, std::optional<std::uint64_t> step) {
    const std::string name = file.name();
    if (TrajectoryReader::reads(file)) return values_of(TrajectoryReader(std::move(file)), name, step);
    return starting_values(TextInput(std::move(file)), step);
}

StartingValues starting_values(TextInput text, std::optional<std::uint64_t> step) {
    const std::string name = text.name();
    const auto file = TextTrajectory::open(std::move(text), TextTrajectory::From::any_program);
    file->require({Column::x, Column::y, Column::z});
    FrameBlock frame;
    bool found = false;
    for (FrameBlock next; !(found && step) && file->next(next);) {
        found = !step || next.moments.front().step == *step;
        if (found) frame = std::move(next);
    }
    if (!found) refuse_step(name, step);
    check_rows(frame, name);
    frame.velocities.resize(frame.rows);
    return {.given = {},
            .positions = std::move(frame.positions),
            .velocities = std::move(frame.velocities),
            .displacements = std::move(frame.displacements)};
}

StartingValues starting_values(const std::string& file_and_step) {
    const FileAtStep at = file_at_step(file_and_step);
    StartingValues values = starting_values(InputFile(at.file), at.step);
    values.given = file_and_step;
    return values;
}

std::string csv_text(const StartingValues& values) {
    FrameBlock frame;
    frame.frame_rows = frame.rows = values.positions.size();
    frame.moments = {{0, 0}};
    frame.positions = values.positions;
    frame.velocities = values.velocities;
    frame.displacements = values.displacements;
    const auto end = values.displacements.empty() ? all_columns.begin() + 6 : all_columns.end();
    const Columns columns(all_columns.begin(), end);
    std::string text = csv_header(columns);
    append_csv(text, frame, columns);
    return text;
}

}  // namespace steplab
