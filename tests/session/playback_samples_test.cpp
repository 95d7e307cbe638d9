// What plots show of the frames of a file.
#include "core/error.hpp"
#include "session/playback_test.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

std::vector<Sample> samples_of(Playback& playback) { return view_of(playback).leading.series.samples; }

void complete(Playback& playback) {
    while (playback.lacks_samples()) playback.sample_on();
}

/// Samples of a run at every second step, of one particle.
void expect_samples_of(const RunDescription& run, const std::vector<Sample>& samples, std::size_t particle) {
    Simulation simulation(run);
    for (const Sample& sample : samples) {
        simulation.advance(sample.step - simulation.step());
        const Diagnostics measured = simulation.diagnostics();
        EXPECT_EQ(sample.kinetic, measured.kinetic);
        EXPECT_EQ(sample.potential, measured.potential);
        EXPECT_EQ(sample.energy_error, measured.energy_error);
        EXPECT_EQ(sample.error, measured.error);
        ASSERT_TRUE(sample.particle());
        EXPECT_EQ(sample.particle()->velocity, simulation.frame().velocities[particle]);
    }
}

TEST(PlaybackSamples, are_of_all_frames_however_it_is_played) {
    for (const Precision precision : precisions) {
        const Written written(run_of("chain", "rk4", precision, 0.1));
        Playback playback(written.path);
        playback.handle(event::Track{5});
        EXPECT_FALSE(playback.lacks_samples()) << "no plot is shown";
        playback.handle(event::ShowSamples{true});
        for (const std::size_t frame : {0U, 3U, 1U}) go_to(playback, frame);
        EXPECT_EQ(samples_of(playback).size(), 3u) << "those that were shown";
        complete(playback);
        EXPECT_EQ(samples_of(playback).size(), written.frames.size());
        expect_samples_of(written.run, samples_of(playback), 5);
        EXPECT_EQ(bits_of(playback.frame()), bits_of(written.frames[1])) << "it stands where it stood";
    }
}

TEST(PlaybackSamples, leave_what_is_told_of_the_frame_that_is_shown) {
    const Written written(played_chain());
    Playback alone(written.path), sampled(written.path);
    sampled.handle(event::ShowSamples{true});
    for (Playback* const playback : {&alone, &sampled}) {
        playback->handle(event::ShowForces{true});
        go_to(*playback, 7);
    }
    complete(sampled);
    const SessionView seen = view_of(sampled), right = view_of(alone);
    EXPECT_EQ(seen.leading.frame.forces, right.leading.frame.forces);
    EXPECT_EQ(seen.leading.diagnostics.energy, right.leading.diagnostics.energy);
    EXPECT_EQ(samples_of(sampled).size(), 24u);
}

TEST(PlaybackSamples, tell_of_other_particles_after_they_were_read_again) {
    const Written written(played_chain());
    Playback playback(written.path);
    playback.handle(event::ShowSamples{true});
    playback.handle(event::Track{5});
    complete(playback);
    playback.handle(event::Track{5});
    EXPECT_FALSE(playback.lacks_samples()) << "it is the same one";
    playback.handle(event::Track{2});
    EXPECT_TRUE(playback.lacks_samples());
    complete(playback);
    expect_samples_of(written.run, samples_of(playback), 2);
    playback.handle(event::AlsoTrack{{7, 8}});
    complete(playback);
    for (const Sample& sample : samples_of(playback)) EXPECT_TRUE(sample.particle(2));
}

TEST(PlaybackSamples, of_a_picture_are_those_up_to_its_frame) {
    const Written written(played_chain());
    Playback playback(written.path);
    playback.handle(event::Track{5});
    playback.handle(event::ShowSamples{true});
    for (const std::size_t frame : {9U, 10U, 23U}) {
        go_to(playback, frame);
        playback.sample_to_here();
        EXPECT_EQ(samples_of(playback).size(), frame + 1);
    }
    expect_samples_of(written.run, samples_of(playback), 5);
}

TEST(PlaybackSamples, leave_out_damaged_frames) {
    const Kept file("1\nTime=0\nH 0 0 0\n1\nTime=1\nH 1 oops 0\n1\nTime=2\nH 2 0 0\n");
    Playback playback(file.name());
    while (playback.look_on()) {
    }
    ASSERT_EQ(playback.frames(), 3u);
    playback.handle(event::Track{0});
    playback.handle(event::ShowSamples{true});
    complete(playback);
    EXPECT_EQ(samples_of(playback).size(), 2u);
    EXPECT_THROW(playback.handle(event::Step{1}), FileError) << "who goes there is told";
}

TEST(PlaybackSamples, of_a_text_tell_where_its_particles_are) {
    const Kept file("1\nTime=0\nH 0 0 0\n1\nTime=1\nH 1 7 0\n1\nTime=2\nH 2 0 -3\n");
    Playback playback(file.name());
    while (playback.look_on()) {
    }
    playback.handle(event::Track{0});
    playback.handle(event::ShowSamples{true});
    complete(playback);
    const std::vector<Sample> samples = samples_of(playback);
    ASSERT_EQ(samples.size(), 3u);
    EXPECT_EQ(samples[1].particle()->displacement, (Vec3{1, 7, 0}));
    EXPECT_EQ(samples[2].particle()->displacement, (Vec3{2, 0, -3}));
    EXPECT_FALSE(view_of(playback).playback->has_velocities);
}

TEST(PlaybackSamples, come_in_the_window_without_being_played) {
    const Written written(played_chain());
    Worker worker{TrajectoryFile{written.path}};
    worker.on_view(News::wake);
    worker.send(event::Track{4});
    worker.send(event::ShowSamples{true});
    SessionView view;
    while (view.leading.series.samples.size() < 24) {
        while (worker.take(view)) {
        }
        ASSERT_TRUE(view.leading.series.samples.size() == 24 || News::wait()) << view.leading.series.samples.size();
    }
    EXPECT_EQ(view.playback->frame, 0u);
    expect_samples_of(written.run, view.leading.series.samples, 4);
}

}  // namespace
}  // namespace steplab::test
