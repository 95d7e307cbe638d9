#include "app/commands/film_times.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "session/compared.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {
namespace {

constexpr double tolerance = 1e-6;  // of a spacing, as step_at() has it of a step
constexpr double most_frames = 1e8;

}  // namespace

std::uint64_t film_frames(double seconds, double spacing) {
    const double frames = std::floor(seconds / spacing + tolerance) + 1;
    if (!(frames <= most_frames)) {
        throw UsageError(fmt::format("a film of {} frames: at most {} are written; a larger --speed makes it shorter",
                                     typed(frames, 3), typed(most_frames)));
    }
    return static_cast<std::uint64_t>(frames);
}

FilmTimes::FilmTimes(const RunDescription& description, const RunEnd& end, double time, double spacing)
    : dt_(rounded_to(description.precision, description.dt)),
      end_(end),
      spacing_(std::copysign(spacing, dt_)),
      count_(film_frames(time / std::copysign(1.0, dt_), spacing)) {}

std::uint64_t FilmTimes::step(std::uint64_t frame) const {
    const double time = static_cast<double>(frame) * spacing_;
    // the last step of a method that chooses its own steps may be shorter
    if (end_.time && time / *end_.time >= 1 - tolerance * spacing_ / *end_.time) return end_.step;
    return std::min(end_.step, step_at(time, dt_));
}

RunEnd FilmTimes::end() const {
    const std::uint64_t last = step(count_ - 1);
    return last == end_.step ? end_ : RunEnd{last};
}

std::optional<std::string> FilmTimes::note() const {
    const double spacing = std::abs(spacing_), dt = std::abs(dt_);
    if (count_ == 1 || dt < 1.5 * spacing) return std::nullopt;
    return fmt::format("steps are {} s long, frames {} s apart: a smaller --dt or a larger --speed moves more smoothly",
                       typed(dt, 3), typed(spacing, 3));
}

}  // namespace steplab
