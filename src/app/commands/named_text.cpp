#include "app/commands/named_text.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {
namespace {

/// Of six digits, as other programs write them.
constexpr double rounding = 1e-5;

double largest(const std::vector<Vec3>& vectors) {
    double most = 0;
    for (const Vec3 v : vectors) most = std::max(most, length(v));
    return most;
}

std::string names_of_further(const FrameBlock& frame) {
    std::string names = frame.types.empty() ? "" : "type";
    for (const ParticleValues& column : frame.values) names += (names.empty() ? "" : ", ") + shown(column.name);
    return names;
}

}  // namespace

NamedText::NamedText(std::string file, const RunDescription& run) : file_(std::move(file)), run_(run), frame_(run) {}

const Frame& NamedText::frame(const FrameBlock& of_text, const FrameParts& wanted) {
    check_is_whole(of_text);
    const FrameBlock::Moment& moment = of_text.moments.front();
    const double time = time_of(moment);
    if (moment.step == 0) check_start(of_text);
    if (left_out_.empty()) left_out_ = names_of_further(of_text);
    std::vector<Vec3> positions = of_text.positions, velocities = of_text.velocities;
    return frame_.at(moment.step, time, positions, velocities, wanted);
}

void NamedText::check_is_whole(const FrameBlock& frame) const {
    bool in_order = frame.rows == frame_.particles();
    for (std::size_t row = 0; in_order && row < frame.rows; ++row) in_order = frame.particle(row) == row;
    if (!in_order)
        throw UsageError(
            fmt::format("the frames of '{}' have {} particles, and the scene {}, which are to be numbered "
                        "from 0 on: is it another scene?",
                        shown(file_), frame.rows, frame_.particles()));
}

void NamedText::check_start(const FrameBlock& frame) const {
    const Frame start = Simulation(run_).frame();
    const auto check = [&](const char* what, const std::vector<Vec3>& in_text, const std::vector<Vec3>& in_scene) {
        const double allowed = rounding * std::max(largest(in_scene), largest(in_text));
        for (std::size_t i = 0; i < in_text.size(); ++i) {
            const double apart = length(in_text[i] - in_scene[i]);
            if (!(apart > allowed)) continue;
            throw UsageError(
                fmt::format("step 0 of '{}' is not the start of the scene, where the {} of particle {} is ({}, {}, "
                            "{}), not ({}, {}, "
                            "{}): are there other parameters? For any other start: --from FILE:0",
                            shown(file_), what, i, number_text(in_scene[i].x), number_text(in_scene[i].y),
                            number_text(in_scene[i].z), number_text(in_text[i].x), number_text(in_text[i].y),
                            number_text(in_text[i].z)));
        }
    };
    check("position", frame.positions, start.positions);
    check("velocity", frame.velocities, start.velocities);
}

/// A text without times has steps in their place.
double NamedText::time_of(const FrameBlock::Moment& moment) const {
    constexpr double rounding_of_times = 1e-6;
    const auto step = static_cast<double>(moment.step);
    const double time = step * run_.dt;
    if (moment.time == step || std::abs(moment.time - time) <= rounding_of_times * std::abs(time)) return time;
    throw UsageError(fmt::format("step {} of '{}' is at {} s, but with --dt {} at {} s: is it another dt?", moment.step,
                                 shown(file_), number_text(moment.time), number_text(run_.dt), number_text(time)));
}

}  // namespace steplab
