#include "session/playback_test.hpp"

#include "core/error.hpp"
#include "support/allocations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

class EveryModel : public testing::TestWithParam<std::pair<const Model*, Precision>> {
protected:
    Written written{small_run_of(GetParam().first->info.id, "verlet", GetParam().second, 0.01)};
};

TEST_P(EveryModel, is_shown_with_the_bits_and_the_energy_of_its_run) {
    Playback playback(written.path);
    ASSERT_EQ(playback.frames(), written.frames.size());
    for (std::size_t i = 0; i < written.frames.size(); ++i) {
        go_to(playback, i);
        const SessionView view = view_of(playback);
        ASSERT_EQ(bits_of(view.leading.frame), bits_of(written.frames[i])) << "frame " << i;
        const Diagnostics &seen = view.leading.diagnostics, &ran = written.measured[i];
        EXPECT_EQ(seen.energy, ran.energy) << "frame " << i;
        EXPECT_EQ(seen.kinetic, ran.kinetic);
        EXPECT_EQ(seen.energy_error, ran.energy_error) << "frame " << i;
        EXPECT_EQ(seen.max_displacement, ran.max_displacement);
        EXPECT_EQ(seen.momentum.y, ran.momentum.y);
        EXPECT_EQ(seen.error, ran.error);
    }
}

TEST_P(EveryModel, has_the_shape_and_the_description_of_its_run) {
    Playback playback(written.path);
    const SessionView view = view_of(playback);
    const Shape &seen = *view.leading.frame.shape, &ran = *written.frames.front().shape;
    EXPECT_EQ(seen.roles, ran.roles);
    EXPECT_EQ(seen.rest, ran.rest);
    EXPECT_EQ(seen.springs.size(), ran.springs.size());
    EXPECT_EQ(seen.box, ran.box);
    EXPECT_EQ(view.leading.description, written.run);
    EXPECT_TRUE(view.playback && view.playback->measured && view.playback->fault.empty());
}

std::vector<std::pair<const Model*, Precision>> every_model() {
    std::vector<std::pair<const Model*, Precision>> all;
    for (const Precision precision : precisions) {
        for (const Model* model : models_for("verlet", precision)) all.emplace_back(model, precision);
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Playback, EveryModel, testing::ValuesIn(every_model()), [](const auto& test) {
    return std::string(test.param.first->info.id) + "_" + std::string(id(test.param.second));
});

TEST(Playback, goes_to_any_frame_from_any_other) {
    const Written written(played_chain());
    Playback playback(written.path);
    for (const std::size_t number : {23u, 0u, 11u, 12u, 4u, 5u, 22u, 1u}) {
        go_to(playback, number);
        EXPECT_EQ(playback.number(), number);
        EXPECT_EQ(bits_of(playback.frame()), bits_of(written.frames[number]));
    }
    playback.handle(event::Step{1'000'000});
    EXPECT_EQ(playback.number(), 23u);
    playback.handle(event::Step{-1'000'000});
    EXPECT_EQ(playback.number(), 0u);
    go_to(playback, 7);
    playback.handle(event::Restart{});
    EXPECT_EQ(playback.number(), 0u);
}

TEST(Playback, goes_to_the_last_frame_that_is_not_later_than_a_step_or_time) {
    for (const double dt : {0.1, -0.1}) {
        const Written written(played_chain(dt));
        Playback playback(written.path);
        for (std::uint64_t step = 0; step < 60; ++step) {
            const std::size_t right = std::min<std::size_t>(step / 2, 23);
            playback.handle(event::Seek{step});
            EXPECT_EQ(playback.number(), right) << "step " << step;
            go_to(playback, 13);
            playback.handle(event::SeekTime{dt * static_cast<double>(step)});
            EXPECT_EQ(playback.number(), right) << "at the time of step " << step;
            playback.handle(event::SeekTime{dt * (static_cast<double>(step) + 0.4)});
            EXPECT_EQ(playback.number(), right) << "after step " << step;
        }
    }
}

TEST(Playback, finds_frames_that_are_not_evenly_spaced) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trajectory");
    const std::vector<std::uint64_t> steps{0, 1, 2, 3, 100, 101, 900, 901, 902, 5000};
    {
        OutputFile file(path);
        TrajectoryWriter writer(file, TrajectoryFormat::trajectory, played_chain(), {});
        Simulation simulation(played_chain());
        for (const std::uint64_t step : steps) {
            simulation.advance(step - simulation.step());
            Frame frame;
            simulation.frame(frame, {.displacements = true});
            writer.add(frame);
        }
        writer.finish();
        file.commit();
    }
    Playback playback(path);
    for (std::uint64_t step = 0; step < 5100; step += 7) {
        const auto after = std::upper_bound(steps.begin(), steps.end(), step);
        const auto right = static_cast<std::uint64_t>(after - steps.begin()) - 1;
        playback.handle(event::Seek{step});
        ASSERT_EQ(playback.number(), right) << "step " << step;
        playback.handle(event::SeekTime{0.1 * static_cast<double>(step)});
        ASSERT_EQ(playback.number(), right) << "at the time of step " << step;
    }
}

/// One of each kind.
std::map<std::size_t, Event> events_of_all_kinds() {
    const RunDescription other = played_chain(0.05);
    const std::vector<Event> all{event::Play{true},       event::Loop{},
                                 event::Step{1},          event::Seek{4},
                                 event::SeekTime{0.8},    event::Restart{},
                                 event::Begin{other},     event::Change{other},
                                 event::SetRate{},        event::Track{3},
                                 event::Do{TurnRound{}},  event::Undo{},
                                 event::Redo{},           event::ShowEnsemble{{.runs = 16}},
                                 event::ShowForces{true}, event::ShowSamples{true},
                                 event::ShowCosts{true},  event::ShowErrors{true},
                                 event::AddRun{other},    event::ChangeRun{1, other},
                                 event::EqualCost{true},  event::RemoveRun{1},
                                 event::Lead{1},          event::Bookmark{},
                                 event::TakeBranch{0},    event::Magnify{3},
                                 event::AlsoTrack{{1}}};
    std::map<std::size_t, Event> events;
    for (const Event& event : all) events.emplace(event.index(), event);
    return events;
}

TEST(Playback, refuses_what_cannot_be_done_to_frames_of_a_file_and_does_all_else) {
    const Written written(played_chain());
    const auto events = events_of_all_kinds();
    ASSERT_EQ(events.size(), std::variant_size_v<Event>) << "a kind of event is not tested";
    for (const auto& [kind, event] : events) {
        Playback playback(written.path);
        const bool possible = is_any<event::Play, event::Loop, event::Step, event::Seek, event::SeekTime,
                                     event::Restart, event::SetRate, event::Track, event::AlsoTrack, event::ShowForces,
                                     event::Magnify, event::ShowSamples, event::Bookmark>(event);
        go_to(playback, 9);
        if (possible) {
            EXPECT_NO_THROW(playback.handle(event)) << "event " << kind;
            continue;
        }
        try {
            playback.handle(event);
            ADD_FAILURE() << "event " << kind << " is not refused";
        } catch (const UsageError& refused) {
            EXPECT_THAT(refused.what(), HasSubstr("a trajectory is played back: "));
        }
        EXPECT_EQ(playback.number(), 9u);
        EXPECT_FALSE(playback.playing());
    }
}

TEST(Playback, shows_forces_tracked_particles_and_bookmarks) {
    const Written written(played_chain());
    Playback playback(written.path);
    Simulation simulation(written.run);
    simulation.advance(8);
    go_to(playback, 4);
    playback.handle(event::ShowForces{true});
    playback.handle(event::Track{5});
    playback.handle(event::Bookmark{"here"});
    playback.handle(event::Magnify{8});
    SessionView view = view_of(playback);
    std::vector<Vec3> forces;
    simulation.forces(forces);
    EXPECT_EQ(view.leading.frame.forces, forces);
    EXPECT_EQ(view.leading.frame.magnified, 8);
    const RunView run = steplab::view_of(simulation, 5);
    ASSERT_TRUE(view.leading.tracked && run.tracked);
    EXPECT_EQ(view.leading.tracked->displacement, run.tracked->displacement);
    EXPECT_EQ(view.leading.tracked->exact_displacement, run.tracked->exact_displacement);
    ASSERT_EQ(view.line.bookmarks.size(), 1u);
    EXPECT_EQ(view.line.bookmarks.front().step, 8u);
    EXPECT_EQ(view.line.reached, 46u);
    playback.handle(event::Bookmark{});
    EXPECT_TRUE(view_of(playback).line.bookmarks.empty());
}

TEST(Playback, of_some_particles_shows_them_alone) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trajectory");
    const std::vector<Frame> frames = frames_of(played_chain(), 3);
    put_text(path, written(played_chain(), frames, TrajectoryFormat::trajectory, {.particles = {2, 5}}));
    Playback playback(path);
    playback.handle(event::Step{2});
    SessionView view = view_of(playback);
    EXPECT_EQ(view.leading.frame.positions, (std::vector<Vec3>{frames[2].positions[2], frames[2].positions[5]}));
    EXPECT_FALSE(view.playback->measured);
    EXPECT_EQ(view.leading.frame.shape->rest.size(), 2u);
    EXPECT_TRUE(view.leading.frame.shape->springs.empty());
    EXPECT_THROW(playback.handle(event::ShowForces{true}), UsageError);
    EXPECT_THROW(continued(view), UsageError);
}

TEST(Playback, cut_anywhere_shows_the_frames_before_or_is_refused) {
    const Written written(played_chain(), 8);
    const std::string bytes = text_of(written.path);
    std::size_t refused = 0, most = 0;
    for (std::size_t length = 0; length < bytes.size(); length += 7) {
        const Kept cut(bytes.substr(0, length));
        try {
            Playback playback(cut.name());
            const SessionView view = view_of(playback);
            EXPECT_TRUE(!view.playback->fault.empty() || playback.frames() == 8) << "cut behind the index";
            most = std::max<std::size_t>(most, playback.frames());
            for (std::size_t i = 0; i < playback.frames(); ++i) {
                go_to(playback, i);
                EXPECT_EQ(bits_of(playback.frame()), bits_of(written.frames[i]));
            }
        } catch (const FileError& error) {
            ++refused;
            EXPECT_THAT(error.what(), HasSubstr(cut.name()));
        }
    }
    EXPECT_GT(refused, 0u);
    EXPECT_EQ(most, 8u) << "the last cuts are in the index";
}

TEST(Playback, of_a_long_file_needs_memory_for_a_frame_alone) {
    constexpr std::size_t frames = 30, least = std::size_t{4} << 20;
    const Written written(run_of("mesh", "euler", Precision::double_, 0.01, {{"dim", 100}}), frames);
    ASSERT_GT(frames * written.frames[0].positions.size() * 9 * sizeof(double), 4 * least) << "all of them";
    const NoLargerThan bound(least);
    Playback playback(written.path);
    SessionView view;
    for (std::size_t i = 0; i < frames; ++i) {
        go_to(playback, (i * 7) % frames);
        playback.observe(view);
    }
    EXPECT_EQ(view.leading.frame.positions.size(), 10000u);
}

TEST(Playback, stays_where_it_is_if_a_frame_is_damaged) {
    const Written written(played_chain());
    std::string bytes = text_of(written.path);
    Playback whole(written.path);
    // the third of five chunks: its content begins behind the frames 0 to 9
    bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
    const Kept damaged(bytes);
    Playback playback(damaged.name());
    std::size_t bad = 0;
    for (std::size_t i = 1; i < playback.frames(); ++i) {
        const std::uint64_t before = playback.number();
        try {
            playback.handle(event::Step{static_cast<std::int64_t>(i - before)});
            EXPECT_EQ(bits_of(playback.frame()), bits_of(written.frames[i]));
        } catch (const FileError&) {
            ++bad;
            EXPECT_EQ(playback.number(), before);
            EXPECT_EQ(bits_of(playback.frame()), bits_of(written.frames[before]));
        }
    }
    EXPECT_GT(bad, 0u);
    EXPECT_LT(bad, playback.frames() / 2);
}

TEST(Playback, of_one_frame_stands_and_of_none_is_refused) {
    const Written one(played_chain(), 1);
    Playback playback(one.path);
    playback.handle(event::Play{true});
    EXPECT_FALSE(playback.playing());
    playback.handle(event::Step{1});
    playback.handle(event::SeekTime{7});
    EXPECT_EQ(playback.number(), 0u);
    EXPECT_EQ(view_of(playback).playback->frames, 1u);
    const Written none(played_chain(), 0);
    EXPECT_THROW(Playback{none.path}, FileError);
    EXPECT_THROW(Playback{"there is no such file"}, FileError);
}

TEST(Playback, is_continued_by_a_run_from_the_frame_that_is_shown) {
    for (const Precision precision : precisions) {
        const Written written(run_of("mesh", "verlet", precision, 0.05, {{"dim", 6}}));
        Playback playback(written.path);
        go_to(playback, 6);
        Simulation run(continued(view_of(playback)));
        EXPECT_EQ(run.frame().positions, written.frames[6].positions);
        EXPECT_EQ(run.frame().velocities, written.frames[6].velocities);
        run.advance(2);
        const double rounding = precision == Precision::float_ ? 1e-5 : 1e-14;  // of half steps, in places up to 10 m
        EXPECT_LE(distance(run.frame(), written.frames[7]), rounding);
        EXPECT_GT(distance(run.frame(), written.frames[6]), 100 * rounding);
        EXPECT_EQ(run.description().start.from->given, written.path + ":12");
    }
}

// A session goes forward in time: it would never come to its next step.
TEST(Playback, of_a_run_backward_in_time_cannot_be_continued) {
    const Written written(played_chain(-0.1));
    Playback playback(written.path);
    go_to(playback, 6);
    EXPECT_THROW(continued(view_of(playback)), UsageError);
}

}  // namespace
}  // namespace steplab::test
