#include "app/commands/pictured_frames.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <unistd.h>
#include <utility>

namespace steplab {

void refuse_scene_beside(const std::string& trajectory) {
    throw UsageError(fmt::format("frames of '{}' are drawn: the scene is that of its run", shown(trajectory)));
}

PicturedFrames::PicturedFrames(const std::string& file, PictureRequest request, std::string program)
    : playback_(file),
      request_(std::move(request)),
      first_time_(playback_.frame().time),
      progress_(1, isatty(STDERR_FILENO) != 0, std::move(program)) {
    for (; playback_.has_more(); playback_.look_on()) check_interruption();
    auto selected = request_.style.selected;
    if (request_.panel && !selected) selected = first_followed(*playback_.frame().shape);
    playback_.handle(event::Track{selected});
    const ParticleList& others = request_.style.selected_too;
    playback_.handle(event::AlsoTrack{{others.begin(), others.end()}});
    if (request_.style.forces) playback_.handle(event::ShowForces{});
    playback_.handle(event::Magnify{request_.style.displacements});
    if (request_.panel) playback_.handle(event::ShowSamples{});
    length_ = length_to({.step = std::numeric_limits<std::uint64_t>::max()});
    show();
}

void PicturedFrames::go_to(const RunEnd& end) {
    if (end.time)
        arrive(event::SeekTime{*end.time});
    else
        arrive(event::Seek{end.step});
}

bool PicturedFrames::go_to(double elapsed) {
    const std::uint64_t before = playback_.number();
    playback_.handle(event::SeekTime{first_time_ + (playback_.runs_backward() ? -elapsed : elapsed)});
    if (length_ > 0) progress_.at_part(elapsed / length_);
    if (playback_.number() == before) return false;
    show();
    return true;
}

std::string PicturedFrames::end_note() const {
    return fmt::format("the file ends at step {}", request_.view.frame.step);
}

void PicturedFrames::arrive(const Event& event) {
    playback_.handle(event);
    show();
}

/// Puts the frame at which it stands into the picture.
void PicturedFrames::show() {
    if (request_.panel) playback_.sample_to_here();
    SessionView view;
    playback_.observe(view);
    request_.view = std::move(view.leading);
    request_.playback = std::move(view.playback);
    request_.line = std::move(view.line);
}

}  // namespace steplab
