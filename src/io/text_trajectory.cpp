#include "io/text_trajectory.hpp"

#include "io/dump_trajectory.hpp"
#include "io/number_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace steplab {

namespace {

/// As long as "step,time,particle", which no other file begins with.
constexpr std::string_view begin_of_csv = "step,time,particle";

std::array<std::vector<Vec3>*, 3> vectors_of(FrameBlock& frame) {
    return {&frame.positions, &frame.velocities, &frame.displacements};
}

}  // namespace

std::unique_ptr<TextTrajectory> TextTrajectory::open(InputFile file) {
    return open(TextInput(std::move(file)), From::steplab);
}

std::unique_ptr<TextTrajectory> TextTrajectory::open(TextInput input, From from) {
    switch (format_of(input, from)) {
        case TextFormat::csv:
            return csv_trajectory(std::move(input));
        case TextFormat::xyz:
            return xyz_trajectory(std::move(input), from);
        default:
            return std::make_unique<DumpTrajectory>(std::move(input));
    }
}

TextFormat format_of(TextInput& input, TextTrajectory::From from) {
    const bool foreign = from == TextTrajectory::From::any_program;
    std::string_view begin = input.peek(begin_of_csv.size());
    if (begin == begin_of_csv) return TextFormat::csv;
    if (foreign && DumpTrajectory::begins(begin)) return TextFormat::dump;
    if (foreign) begin.remove_prefix(std::min(begin.find_first_not_of(" \t"), begin.size()));
    if (!begin.empty() && begin[0] >= '0' && begin[0] <= '9') return TextFormat::xyz;
    if (begin.starts_with("run,step")) input.fail("it holds the runs of an ensemble: convert reads files of one run");
    input.fail("it is none of steplab's formats (trajectory, CSV, extended XYZ), and no LAMMPS dump");
}

void TextTrajectory::require(const Columns& columns) const {
    for (const Column column : columns) {
        if (!contains(columns_, column))
            input_.fail(fmt::format("it has no column {}, only {}", id(column), names_of(columns_)));
    }
}

bool TextTrajectory::next(FrameBlock& frame) {
    frame = FrameBlock();
    frame.first_frame = frames_;
    if (!read(frame)) return false;
    frame.frame_rows = frame.rows;
    ++frames_;
    return true;
}

void TextTrajectory::add_row(FrameBlock& frame) const {
    const auto vectors = vectors_of(frame);
    ++frame.rows;
    for (const Column column : columns_) vectors[static_cast<std::size_t>(column) / 3]->resize(frame.rows);
}

void TextTrajectory::set(FrameBlock& frame, Column column, std::string_view word) const {
    constexpr std::array<double Vec3::*, 3> components{&Vec3::x, &Vec3::y, &Vec3::z};
    const auto place = static_cast<std::size_t>(column);
    const bool single = frame.scene.precision == Precision::float_;
    vectors_of(frame)[place / 3]->back().*components[place % 3] =
        single ? static_cast<double>(number<float>(word)) : number<double>(word);
}

template <class Number>
Number TextTrajectory::number(std::string_view word) const {
    const auto value = number_in<Number>(word);
    if (!value) input_.fail(no_number_text(word));
    return *value;
}
template float TextTrajectory::number<float>(std::string_view) const;
template double TextTrajectory::number<double>(std::string_view) const;
template std::uint64_t TextTrajectory::number<std::uint64_t>(std::string_view) const;

}  // namespace steplab
