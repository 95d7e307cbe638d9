#include "io/text_trajectory.hpp"

#include "core/shown.hpp"
#include "io/dump_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace steplab {

namespace {

/// As long as "step,time,particle", which no other file begins with.
constexpr std::string_view csv_begin = "step,time,particle";

std::array<std::vector<Vec3>*, 3> vectors_of(FrameBlock& frame) {
    return {&frame.positions, &frame.velocities, &frame.displacements};
}

}  // namespace

std::unique_ptr<TextTrajectory> TextTrajectory::open(InputFile file) {
    return open(TextInput(std::move(file)), From::steplab);
}

std::unique_ptr<TextTrajectory> TextTrajectory::open(TextInput input, From from) {
    std::string_view begin = input.peek(csv_begin.size());
    if (begin == csv_begin) return csv_trajectory(std::move(input));
    if (from == From::any_program && DumpTrajectory::begins(begin))
        return std::make_unique<DumpTrajectory>(std::move(input));
    if (from == From::any_program) begin.remove_prefix(std::min(begin.find_first_not_of(" \t"), begin.size()));
    if (!begin.empty() && begin[0] >= '0' && begin[0] <= '9') return xyz_trajectory(std::move(input), from);
    if (begin.starts_with("run,step")) input.fail("it holds the runs of an ensemble: convert reads files of one run");
    input.fail("it is none of steplab's formats (CSV and XYZ of --out, trajectory), and no LAMMPS dump");
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
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    bool right = result.ec == std::errc{} && result.ptr == word.data() + word.size();
    if constexpr (std::is_floating_point_v<Number>) right = right && std::isfinite(value);
    if (!right) input_.fail(fmt::format("\"{}\" is not a number that can stand here", shown(word)));
    return value;
}
template float TextTrajectory::number<float>(std::string_view) const;
template double TextTrajectory::number<double>(std::string_view) const;
template std::uint64_t TextTrajectory::number<std::uint64_t>(std::string_view) const;

}  // namespace steplab
