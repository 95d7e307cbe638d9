#pragma once

#include "app/cli/progress.hpp"
#include "app/offscreen/module.hpp"
#include "session/playback.hpp"
#include "sim/run/run_description.hpp"

#include <string>
#include <utility>

namespace steplab {

/// Throws UsageError: the scene of a picture of this file is that of its run.
[[noreturn]] void refuse_scene_beside(const std::string& trajectory);

/// The frames of a trajectory file as pictures (--trajectory).
class PicturedFrames {
public:
    /// Looks through the whole file, and stands at its first frame. `request`: the picture without its run. Progress of
    /// a film is shown on standard error, as PicturedRuns show it. Throws FileError, UsageError, Interrupted.
    PicturedFrames(const std::string& file, PictureRequest request, std::string program = {});

    /// Time from the first frame to the last one that is no later than this end, in seconds of the run.
    double length_to(const RunEnd& end) { return playback_.elapsed_to(end); }
    double length() const { return length_; }
    /// To the last frame that is no later than this. Throws FileError if it is damaged.
    void go_to(const RunEnd& end);
    /// The same, so many seconds of the run after the first frame. False if that is where it stood.
    bool go_to(double elapsed);

    /// Why the file has no more frames, where this end lies behind its last one; empty if it is whole. Throws
    /// FileError.
    std::string fault_before(const RunEnd& end) { return ends_before(end) ? playback_.fault() : ""; }
    /// True if the file ends earlier.
    bool ends_before(const RunEnd& end) const { return playback_.ends_before(end); }
    /// Says at which step it ends, which is that of the picture.
    std::string end_note() const;

    /// The picture of the moment.
    const PictureRequest& request() const { return request_; }
    /// Draws all pictures from now on with this camera.
    void keep_camera(std::string camera) { request_.camera = std::move(camera); }
    /// Clears what is shown of the progress.
    void end_progress() { progress_.clear(); }

private:
    void arrive(const Event& event);
    void show();

    Playback playback_;
    PictureRequest request_;
    double first_time_ = 0, length_ = 0;
    Progress progress_;
};

}  // namespace steplab
