#pragma once

#include "session/event.hpp"
#include "session/played_frames.hpp"
#include "session/sampled_frames.hpp"
#include "session/session_view.hpp"
#include "sim/run/state_meter.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// Plays the frames of a trajectory, CSV or XYZ file or a LAMMPS dump in place of a session: the same time line, to
/// whose events it answers in the same way. Each frame is read when it is gone to; memory is that of one frame and the
/// index, however many there are. It has neither a thread nor a clock of its own.
class Playback {
public:
    /// Stands at the first frame. Throws FileError if the file cannot be read, has no rows or holds no frame;
    /// UsageError if its run does not fit into memory; Interrupted.
    explicit Playback(const std::string& file);

    /// Does what an event says. Throws UsageError for what cannot be done to frames of a file, FileError if a frame is
    /// damaged; nothing has changed then.
    void handle(const Event& event);

    /// The description of the run that wrote the file; of a text, unknown_run().
    const RunDescription& run() const { return run_; }
    std::uint64_t frames() const { return file_frames_->frames(); }
    /// True if frames may come yet: the file is still being looked through, or written.
    bool can_grow() const { return file_frames_->can_grow(); }
    /// True if there is more of it to be looked through at once.
    bool has_more() const { return file_frames_->has_more(); }
    /// Looks through some more of it. True if there is something new to see.
    bool look_on();
    /// The number of the frame at which it stands, counted from 0.
    std::uint64_t number() const { return number_; }
    /// That frame.
    const Frame& frame() const { return frame_; }
    bool playing() const { return playing_; }
    Rate rate() const { return rate_; }
    void stop() { playing_ = false; }

    /// Seconds from the first frame to this one, and to the one that is played next, or the same at the last: they
    /// never decrease from frame to frame, also where time runs backward.
    double elapsed() const { return elapsed_at(frame_.time); }
    double next_elapsed() const { return elapsed_at(next_time_); }
    /// The same to the last frame that is no later than an end. Reads no frame but its moment. Throws FileError.
    double elapsed_to(const RunEnd& end);
    /// True if its last frame is earlier.
    bool ends_before(const RunEnd& end) const;
    /// True if its frames go backward in time.
    bool runs_backward() const { return backward_; }
    /// Why there are no more frames; empty if the file is whole.
    std::string fault() const { return file_frames_->fault(); }
    /// While it plays: to the last frame that is no later than so many seconds after the first, or the next one; or
    /// backwards in the same way. It stops at the last frame; in a loop it goes to the other end, which is then true.
    /// Throws FileError.
    bool play_to(double elapsed);
    bool play_next();
    bool plays_backwards() const { return playing_ && backwards_; }

    /// True if plots lack a frame that is not read yet.
    bool lacks_samples() const { return lacks_samples_; }
    /// Reads one of them; one that is damaged is left out.
    void sample_on();
    /// Reads all of them up to the frame at which it stands. Throws Interrupted.
    void sample_to_here();

    /// The present moment, reusing the memory of `view`. Throws UsageError if forces cannot be computed.
    void observe(SessionView& view);

private:
    struct Handle;

    void go_to(std::uint64_t frame);
    void arrive();
    void find_end();
    void use_box();
    void play(const event::Play& play);
    std::uint64_t first_played();
    std::uint64_t last_played();
    std::uint64_t end_of(bool late);
    std::uint64_t first_frame_from(double elapsed);
    std::uint64_t frame_of(std::uint64_t step);
    std::uint64_t frame_at(double elapsed);
    std::uint64_t frame_at_time(double time);
    template <class Ahead>
    std::uint64_t last_frame(double part, const Ahead& ahead);
    double elapsed_at(double time) const { return backward_ ? first_time_ - time : time - first_time_; }
    double spacing() const;
    bool is_measured() const { return meter_.has_value(); }
    void bookmark(const std::string& text);
    void find_next();
    void observe(RunView& view);
    Tracked tracked(std::size_t particle, const Frame& frame) const;
    Diagnostics measure(const Frame& frame);
    Sample sample(const Frame& frame, const Diagnostics& measured) const;
    void sample_frame(std::uint64_t number);
    void follow_tracked();
    void take_sample();

    std::string file_;
    std::unique_ptr<PlayedFrames> file_frames_;
    RunDescription run_;
    std::optional<StateMeter> meter_;  ///< none where rows of some particles alone are in the file
    std::shared_ptr<const Shape> shape_;
    bool has_velocities_ = true;
    std::string units_;
    bool backward_ = false;
    double first_time_ = 0, last_time_ = 0;
    std::uint64_t last_step_ = 0;
    double first_energy_ = 0;
    std::uint64_t number_ = 0;
    double next_time_ = 0;
    Frame frame_, read_;  ///< that is shown, and the one before it, whose memory the next one uses
    Diagnostics diagnostics_;
    bool playing_ = false;
    bool backwards_ = false;
    std::optional<StepRange> loop_;
    Rate rate_;
    std::optional<std::size_t> tracked_;
    std::vector<std::size_t> also_tracked_;
    bool with_forces_ = false, with_samples_ = false, lacks_samples_ = false;
    double magnified_ = 1;
    SampledFrames sampled_frames_;
    RunSamples samples_{0};
    std::vector<Mark> bookmarks_;
};

/// What is known of a file before it is played.
struct PlayedStart {
    RunDescription run;                     ///< that wrote it
    std::vector<std::string> columns = {};  ///< names of the further values of the particles of its first frame
    std::size_t particles = 0;              ///< of its first frame, where the run does not say how many; else 0
};

/// Reads no more than the first frame. Throws FileError if that cannot be played.
PlayedStart played_start(const std::string& file);

/// A run from the moment of a trajectory that is shown, of the scene and with the method of the file.
/// Throws UsageError if the file does not hold all of its scene, or goes backward in time as no session does.
RunDescription continued(const SessionView& view);

}  // namespace steplab
