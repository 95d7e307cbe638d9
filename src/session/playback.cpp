#include "session/playback.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/indexed_text.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "session/marks.hpp"
#include "session/played_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {
namespace {

[[noreturn]] void refuse_file(const std::string& file, std::string_view why) {
    throw FileError(fmt::format("cannot play '{}': {}", shown(file), why));
}

}  // namespace

Playback::Playback(const std::string& file)
    : file_(file), file_frames_(played_frames(file)), sampled_frames_(file_frames_->rows()) {
    const std::optional<RunDescription> described = file_frames_->run();
    run_ = described ? *described : unknown_run(file);
    if (frames() == 0) refuse_file(file_, "it holds no whole frame");
    first_time_ = file_frames_->moment(0).time;
    find_end();
    file_frames_->frame(0, frame_);
    if (frame_.positions.size() != file_frames_->rows() || frame_.positions.empty())
        refuse_file(file_, "it holds no positions");
    if (described && static_cast<double>(frame_.positions.size()) == model_of(run_).particles(as_held(run_).scene))
        meter_.emplace(run_);
    has_velocities_ = file_frames_->has_velocities();  // known once: it may take reading the first frame
    if (const std::string units = file_frames_->units(); units != "lj") units_ = units;
    shape_ = meter_ ? meter_->shape() : played_shape(*file_frames_, frame_);
    arrive();
}

void Playback::find_end() {
    const FrameBlock::Moment last = file_frames_->moment(frames() - 1);
    last_time_ = last.time;
    last_step_ = last.step;
    backward_ = last_time_ < first_time_;
    if (sampled_frames_.adapt(frames())) samples_.clear();
    lacks_samples_ = with_samples_;
}

bool Playback::look_on() {
    if (!file_frames_->look_on()) return false;
    find_end();
    find_next();
    return true;
}

/// One function for each kind of event.
struct Playback::Handle {
    Playback& of;

    [[noreturn]] void refuse(std::string_view why) const {
        throw UsageError(fmt::format("a trajectory is played back: {}{}", why,
                                     of.is_measured() ? "; \"continue from here\" begins a run" : ""));
    }
    void refuse(bool wrong, std::string_view why) const {
        if (wrong) refuse(why);
    }

    void operator()(const event::Play& play) const { of.play(play); }
    void operator()(const event::Loop& loop) const {
        check(loop);
        of.loop_ = loop.steps;
        of.find_next();
    }
    void operator()(const event::Step& step) const {
        of.stop();
        const auto size = step.steps < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(step.steps)
                                         : static_cast<std::uint64_t>(step.steps);
        of.go_to(step.steps < 0 ? of.number_ - std::min(of.number_, size)
                                : of.number_ + std::min(of.frames() - 1 - of.number_, size));
    }
    void operator()(const event::Seek& seek) const { of.go_to(of.frame_of(seek.step)); }
    void operator()(const event::SeekTime& seek) const { of.go_to(of.frame_at_time(seek.time)); }
    void operator()(const event::Restart&) const { of.go_to(0); }
    void operator()(const event::SetRate& rate) const { of.rate_ = rate.rate; }
    void operator()(const event::Track& track) const {
        of.tracked_ = track.particle;
        of.follow_tracked();
    }
    void operator()(const event::AlsoTrack& track) const {
        of.also_tracked_ = track.particles;
        of.follow_tracked();
    }
    void operator()(const event::ShowSamples& show) const {
        of.with_samples_ = of.lacks_samples_ = show.on;
        of.take_sample();
    }
    void operator()(const event::ShowForces& show) const {
        refuse(show.on && !of.is_measured(), "forces are known only of whole scenes");
        of.with_forces_ = show.on;
    }
    void operator()(const event::Magnify& magnify) const { of.magnified_ = magnify.factor; }
    void operator()(const event::Bookmark& mark) const { of.bookmark(mark.text); }
    void operator()(const event::Begin&) const { refuse("another run takes the place of the trajectory"); }
    void operator()(const event::Change&) const { refuse("its method, dt and parameters are those of its run"); }
    void operator()(const event::Do&) const { refuse("its particles cannot be moved"); }
    void operator()(const event::Undo&) const { refuse("nothing was done that could be undone"); }
    void operator()(const event::Redo&) const { refuse("nothing was undone"); }
    void operator()(const event::ShowEnsemble& show) const {
        refuse(show.ensemble.runs > 0, "no ensemble goes beside it");
    }
    void operator()(const event::ShowErrors& show) const { refuse(show.on, "it is not compared with a reference"); }
    void operator()(const event::ShowCosts& show) const { refuse(show.on, "what accuracy costs is measured of runs"); }
    void operator()(const event::AddRun&) const { refuse("no runs go beside it"); }
    void operator()(const event::ChangeRun&) const { refuse("no runs go beside it"); }
    void operator()(const event::EqualCost&) const { refuse("no runs go beside it"); }
    void operator()(const event::RemoveRun&) const { refuse("no runs go beside it"); }
    void operator()(const event::Lead&) const { refuse("no runs go beside it"); }
    void operator()(const event::TakeBranch&) const { refuse("it has no branches"); }
};

void Playback::handle(const Event& event) { std::visit(Handle{*this}, event); }

/// Behind the last frame it begins with the first one; backwards, the other way round.
void Playback::play(const event::Play& play) {
    backwards_ = play.backwards;
    playing_ = play.on && frames() > 1;
    if (playing_ && number_ == last_played()) go_to(first_played());
    find_next();
}

/// Where playing begins and ends: the ends of the loop unless it stands outside, else those of the file.
std::uint64_t Playback::first_played() { return end_of(backwards_); }
std::uint64_t Playback::last_played() { return end_of(!backwards_); }

std::uint64_t Playback::end_of(bool late) {
    const std::uint64_t end = late ? frames() - 1 : 0;
    if (!loop_) return end;
    const std::uint64_t first = frame_of(loop_->first), last = frame_of(loop_->last);
    if (late) return number_ <= last ? last : end;
    return number_ >= first ? first : end;
}

bool Playback::play_to(double elapsed) {
    if (!playing_) return false;
    if (!(backwards_ ? elapsed <= next_elapsed() : elapsed >= next_elapsed())) return false;
    const std::uint64_t last = last_played();
    if (loop_ && number_ == last) {
        go_to(frame_of(backwards_ ? loop_->last : loop_->first));
        return true;
    }
    if (backwards_) {
        go_to(std::max(last, std::min(number_ - 1, first_frame_from(elapsed))));
    } else {
        go_to(std::min(last, std::max(number_ + 1, frame_at(elapsed))));
    }
    if (!loop_ && number_ == last) stop();
    return false;
}

bool Playback::play_next() { return play_to(next_elapsed()); }

/// A frame that cannot be read leaves everything as it is.
void Playback::go_to(std::uint64_t frame) {
    if (frame == number_) return;
    file_frames_->frame(frame, read_);
    if (read_.positions.size() != shape_->rest.size()) refuse_file(file_, fmt::format("frame {} is damaged", frame));
    std::swap(read_, frame_);
    number_ = frame;
    arrive();
}

/// A box may be another in each frame.
void Playback::use_box() {
    const Shape& read = *frame_.shape;
    if (meter_ || (read.box == shape_->box && read.corner == shape_->corner)) return;
    Shape shape = *shape_;
    shape.box = read.box;
    shape.corner = read.corner;
    shape_ = std::make_shared<const Shape>(std::move(shape));
}

void Playback::arrive() {
    use_box();
    frame_.shape = shape_;
    frame_.ensemble.clear();
    find_next();
    diagnostics_ = measure(frame_);
    if (number_ == 0) {
        first_energy_ = diagnostics_.energy;
        diagnostics_.energy_error = 0;
    }
    take_sample();
}

/// One that is damaged is due at once: then that is reported.
void Playback::find_next() {
    next_time_ = frame_.time;
    if (number_ == (backwards_ ? 0 : frames() - 1)) {
        if (loop_) next_time_ += backwards_ == backward_ ? spacing() : -spacing();
        return;
    }
    try {
        next_time_ = file_frames_->moment(backwards_ ? number_ - 1 : number_ + 1).time;
    } catch (const FileError&) {
        return;
    }
}

void Playback::bookmark(const std::string& text) { toggle_mark(bookmarks_, {frame_.step, frame_.time, text}); }

void Playback::observe(SessionView& view) {
    view.followers.clear();
    view.errors.reset();
    view.error_series.clear();
    view.costs.reset();
    view.equal_cost = false;
    view.line = {.reached = last_step_, .reached_time = last_time_, .bookmarks = bookmarks_};
    view.line.backwards = playing_ && backwards_;
    if (loop_)
        view.line.loop = {file_frames_->moment(frame_of(loop_->first)).time,
                          file_frames_->moment(frame_of(loop_->last)).time};
    view.playback = PlaybackView{
        file_, number_, frames(), file_frames_->fault(), is_measured(), has_velocities_, file_frames_->looked_through(),
        units_};
    observe(view.leading);
}

/// What is not known of frames of a file is as in a new view.
void Playback::observe(RunView& view) {
    Frame frame = std::move(view.frame);
    SampleSeries series = std::move(view.series);
    frame = frame_;
    samples_.put_into(series);
    view = RunView();
    view.description = run_;
    view.facts = facts_of(run_);
    view.frame = std::move(frame);
    view.frame.magnified = magnified_;
    view.series = std::move(series);
    view.diagnostics = diagnostics_;
    if (meter_) {
        if (with_forces_) meter_->forces(view.frame.forces);
        view.conservation = meter_->conservation();
        view.has_exact = meter_->exact() != nullptr;
    }
    tell_of(
        samples_.followed(), frame_.positions.size(),
        [this](std::size_t particle) { return tracked(particle, frame_); }, view);
    view.playing = playing_;
    view.can_step_back = number_ > 0;
    view.rate = rate_;
    view.dt = run_.origin && !is_measured() ? spacing() : rounded_to(run_.precision, run_.dt);
    view.opening_dt = view.dt;
}

PlayedStart played_start(const std::string& file) {
    InputFile input(file);
    if (TrajectoryReader::reads(input)) return {Playback(file).run()};
    FrameBlock first;
    const auto text = TextTrajectory::open(TextInput(std::move(input)), TextTrajectory::From::any_program);
    text->require({Column::x, Column::y, Column::z});
    if (!text->next(first)) refuse_file(file, "it holds no frame");
    PlayedStart start{unknown_run(file), {}, first.rows};
    for (const ParticleValues& column : first.values) start.columns.push_back(column.name);
    return start;
}

RunDescription continued(const SessionView& view) {
    if (!view.playback || !view.playback->measured || view.leading.description.dt < 0)
        throw UsageError("only a trajectory with all particles of its scene, forward in time, can be continued");
    const Frame& frame = view.leading.frame;
    RunDescription run = view.leading.description;
    run.start = {.from = std::make_shared<const StartingValues>(
                     StartingValues{.given = fmt::format("{}:{}", view.playback->file, frame.step),
                                    .positions = frame.positions,
                                    .velocities = frame.velocities,
                                    .displacements = frame.displacements})};
    return run;
}

}  // namespace steplab
