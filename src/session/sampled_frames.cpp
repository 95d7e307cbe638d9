#include "session/sampled_frames.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace steplab {
namespace {

/// Of fewer a plot would show a motion that is not there.
constexpr std::uint64_t fewest = 8;
/// Over all of the file. A file of chunks is read a chunk at a time, so those behind them come in order.
constexpr std::uint64_t first_frames = 64;

}  // namespace

SampledFrames::SampledFrames(std::uint64_t rows)
    : most_(std::min(most_frames, most_rows / std::max<std::uint64_t>(rows, 1))) {
    if (most_ < fewest) most_ = 0;
}

bool SampledFrames::adapt(std::uint64_t frames) {
    if (most_ == 0) return false;
    const std::uint64_t wanted = std::bit_ceil((frames + most_ - 1) / most_);
    if (wanted <= spacing_) return false;
    spacing_ = wanted;
    restart();
    return true;
}

std::optional<std::uint64_t> SampledFrames::next(std::uint64_t end) {
    if (most_ == 0) return std::nullopt;
    while (true) {
        if (const auto number = next_of_pass()) return number;
        begin_ = end_;
        if (begin_ >= end) return std::nullopt;
        begin_pass(end);
    }
}

void SampledFrames::restart() { begin_ = end_ = 0; }

void SampledFrames::begin_pass(std::uint64_t end) {
    end_ = end;
    coarse_ = std::max(spacing_, std::bit_ceil((end_ - begin_) / first_frames));
    begin_step(coarse_);
}

/// From the first multiple of this step on.
void SampledFrames::begin_step(std::uint64_t step) {
    step_ = step;
    place_ = (begin_ + step - 1) / step * step;
}

std::optional<std::uint64_t> SampledFrames::next_of_pass() {
    for (; begin_ < end_; begin_step(spacing_)) {
        for (; place_ < end_; place_ += step_) {
            if (step_ < coarse_ && place_ % coarse_ == 0) continue;  // it was among the first ones
            return std::exchange(place_, place_ + step_);
        }
        if (step_ == spacing_) break;
    }
    return std::nullopt;
}

}  // namespace steplab
