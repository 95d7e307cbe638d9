#include "session/run_samples.hpp"

#include "io/scene_file.hpp"
#include "session/session.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace steplab::test {
namespace {

std::vector<Sample> samples_of(const Session& session) {
    SessionView view;
    session.observe(view);
    return view.leading.series.samples;
}

Session sampled(const RunDescription& run) {
    Session session(run);
    session.handle(event::Track{0});
    session.handle(event::ShowSamples{true});
    return session;
}

void expect_same(const std::vector<Sample>& a, const std::vector<Sample>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].step, b[i].step);
        EXPECT_EQ(a[i].time, b[i].time);
        EXPECT_EQ(a[i].kinetic, b[i].kinetic);
        EXPECT_EQ(a[i].potential, b[i].potential);
        EXPECT_EQ(a[i].energy_error, b[i].energy_error);
        ASSERT_EQ(a[i].particle() != nullptr, b[i].particle() != nullptr);
        if (a[i].particle()) {
            EXPECT_EQ(a[i].particle()->displacement, b[i].particle()->displacement);
            EXPECT_EQ(a[i].particle()->velocity, b[i].particle()->velocity);
        }
    }
}

/// Of every model, in both precisions, and of every scene that comes with the program.
std::vector<RunDescription> all_runs() {
    std::vector<RunDescription> runs;
    for (const std::string& model : model_ids()) {
        for (const Precision precision : precisions) runs.push_back(run_of(model, "rk4", precision, 0.01, {}));
    }
    for (const std::string& scene : shipped_scenes()) runs.push_back(describe(find_scene(scene)));
    return runs;
}

// Also where particles have no places of their own and are counted from elsewhere; as the exact solution is told.
TEST(RunSamples, tell_how_far_a_particle_is_from_where_it_belongs) {
    for (const RunDescription& run : all_runs()) {
        SCOPED_TRACE(run.model);
        Session session(run);
        const std::size_t last = session.run().particles() - 1;
        session.handle(event::Track{last});
        session.handle(event::ShowSamples{true});
        session.advance(4);
        SessionView view;
        session.observe(view);
        const Sample& now = view.leading.series.samples.back();
        ASSERT_TRUE(now.particle());
        const Frame& frame = view.leading.frame;
        const Vec3 place = frame.positions[last], rest = frame.shape->rest[last];
        const double rounding = run.precision == Precision::float_ ? 1e-7 : 1e-15;
        const double digit = rounding * (length(place) + length(rest) + frame.shape->spacing);
        EXPECT_LE(length(now.particle()->displacement - (place - rest)), digit);
        if (now.particle()->exact_displacement) {
            EXPECT_LE(length(now.particle()->displacement - *now.particle()->exact_displacement), *now.error + digit);
        }
    }
}

// However it is played: in one go, in pieces, there and back.
TEST(RunSamples, of_the_same_run_are_the_same_rows) {
    for (const char* const method : {"rk4", "verlet", "dopri5"}) {
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            SCOPED_TRACE(method);
            const RunDescription run = run_of("chain", method, precision, 0.1, {});
            Session once = sampled(run), pieces = sampled(run), back = sampled(run);
            once.advance(20000);
            std::mt19937 random(2008);
            for (std::uint64_t step = 0; step < 20000;) {
                const std::uint64_t next = std::min<std::uint64_t>(20000, step + 1 + random() % 700);
                pieces.advance(next - step);
                step = next;
            }
            back.advance(20000);
            back.handle(event::Seek{777});
            back.finish();
            back.handle(event::Seek{20000});
            back.finish();
            expect_same(samples_of(pieces), samples_of(once));
            expect_same(samples_of(back), samples_of(once));
        }
    }
}

TEST(RunSamples, change_no_bit_of_a_run) {
    for (const char* const model : {"chain", "rope", "morse"}) {
        const RunDescription run = run_of(model, "rk4", Precision::double_, 0.01, {});
        Session with = sampled(run), without(run);
        with.advance(3000);
        without.advance(3000);
        EXPECT_EQ(with.run().hash(), without.run().hash());
    }
}

TEST(RunSamples, are_what_the_run_says_at_their_steps) {
    const RunDescription run = run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 5}});
    Session session = sampled(run);
    session.advance(100);
    const auto samples = samples_of(session);
    ASSERT_EQ(samples.size(), 101u) << "each step, the start too";
    Simulation alone(run);
    for (const Sample& sample : samples) {
        const Diagnostics now = alone.diagnostics();
        ASSERT_EQ(sample.step, alone.step());
        EXPECT_EQ(sample.energy_error, now.energy_error);
        EXPECT_EQ(sample.kinetic + sample.potential, now.energy);
        EXPECT_EQ(sample.particle()->velocity, alone.frame().velocities[0]);
        alone.advance(1);
    }
}

// That it diverged is found some steps later, whether it stood at its last good step before or not.
TEST(RunSamples, end_with_the_last_good_step_of_a_run_that_diverges) {
    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{28}}) {
        Session session(run_of("rope", "velocity-verlet", Precision::double_, 0.08));
        session.handle(event::ShowSamples{true});
        session.advance(first);
        session.advance(1000);
        ASSERT_TRUE(session.line().is_over());
        ASSERT_EQ(session.run().step(), 28u);
        SampleSeries series;
        session.line().put_samples_into(series);
        EXPECT_EQ(series.samples.back().step, 28u) << first;
    }
}

TEST(RunSamples, take_bounded_memory_however_long_a_run_is) {
    RunSamples samples(10);
    for (std::uint64_t step = 0; step < 1'000'000'000; step += samples.to_next(step))
        samples.put(sample_of(step, 0, {}));
    EXPECT_LT(samples.all().size(), RunSamples::most);
    EXPECT_GT(samples.all().size(), RunSamples::most / 4);
    EXPECT_EQ(samples.all().front().step, 0u);
    EXPECT_GT(samples.all().back().step, 999'000'000u);
    for (std::size_t i = 1; i < samples.all().size(); ++i)
        ASSERT_EQ(samples.all()[i].step - samples.all()[i - 1].step, samples.spacing());
}

TEST(RunSamples, of_a_way_that_was_left_come_back_with_it) {
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 0.1, {}));
    session.advance(100);
    const auto whole = samples_of(session);
    session.handle(event::Seek{40});
    session.finish();
    EXPECT_EQ(samples_of(session).size(), 101u) << "what lies ahead is kept";
    session.handle(event::Do{Kick{3, {1, 0, 0}}});
    EXPECT_EQ(samples_of(session).size(), 41u) << "until something else is done";
    session.advance(60);
    session.handle(event::TakeBranch{0});
    expect_same(samples_of(session), whole);
}

TEST(RunSamples, of_another_particle_are_taken_from_now_on) {
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 0.1, {}));
    session.advance(10);
    session.handle(event::Track{3});
    session.advance(10);
    const auto samples = samples_of(session);
    EXPECT_FALSE(samples[5].particle());
    EXPECT_TRUE(samples[15].particle());
    session.handle(event::Seek{0});
    session.finish();
    session.handle(event::Seek{20});
    session.finish();
    EXPECT_TRUE(samples_of(session)[5].particle()) << "and where it is gone through again";
}

/// What samples tell of the particle in a place, as of the only one.
std::vector<Sample> told_of(std::vector<Sample> samples, std::size_t place) {
    for (Sample& sample : samples) sample.particles = {sample.particles.at(place)};
    return samples;
}

TEST(RunSamples, of_several_particles_are_what_each_alone_has) {
    for (const char* const model : {"chain", "morse", "mesh"}) {
        Session session = sampled(run_of(model, "rk4", Precision::double_, 0.1, {}));
        session.handle(event::Track{3});
        session.handle(event::AlsoTrack{{7, 1, 3, 900'000'000}});
        session.advance(20);
        ASSERT_EQ(samples_of(session).front().particles.size(), 3u) << "each once, of those that there are";
        for (const auto& [place, particle] : {std::pair(0, 3), std::pair(1, 7), std::pair(2, 1)}) {
            SCOPED_TRACE(particle);
            Session alone = sampled(session.run().description());
            alone.handle(event::Track{particle});
            alone.advance(20);
            expect_same(told_of(samples_of(session), static_cast<std::size_t>(place)), samples_of(alone));
        }
    }
}

TEST(RunSamples, of_a_particle_stay_while_others_come_and_go) {
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 0.1, {}));
    session.handle(event::AlsoTrack{{5}});
    session.advance(20);
    const auto both = samples_of(session);
    session.handle(event::Track{5});
    expect_same(samples_of(session), told_of(both, 1));
    session.handle(event::AlsoTrack{{2}});
    expect_same(told_of(samples_of(session), 0), told_of(both, 1));
    EXPECT_FALSE(samples_of(session)[4].particle(1)) << "that of particle 2 is not known yet";
    while (session.lacks_samples()) session.complete_samples([] { return false; });
    Session always = sampled(session.run().description());
    always.handle(event::Track{5});
    always.handle(event::AlsoTrack{{2}});
    always.advance(20);
    for (const std::size_t place : {0U, 1U})
        expect_same(told_of(samples_of(session), place), told_of(samples_of(always), place));
}

TEST(RunSamples, tell_of_so_many_particles_at_most) {
    std::vector<std::size_t> many;
    for (std::size_t i = 1; i < 30; ++i) many.push_back(i);
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 0.1, {{"n", 40}}));
    session.handle(event::AlsoTrack{many});
    session.advance(2);
    EXPECT_EQ(samples_of(session).back().particles.size(), Sample::most_particles);
    session.handle(event::Track{std::nullopt});
    session.advance(2);
    EXPECT_TRUE(samples_of(session).back().particles.empty()) << "others are besides a first one";
}

TEST(RunSamples, are_fewer_where_one_takes_long) {
    EXPECT_EQ(RunSamples(1000).spacing(), 1u);
    EXPECT_GE(RunSamples(1'000'000).spacing(), 128u);
}

TEST(RunSamples, of_a_view_grow_at_their_end) {
    RunSamples samples(1);
    SampleSeries series;
    for (std::uint64_t step = 0; step < 3 * RunSamples::most; ++step) {
        samples.put(sample_of(step, static_cast<double>(step), {}));
        if (step % 7 == 0) samples.put_into(series);
    }
    samples.put_into(series);
    ASSERT_EQ(series.samples.size(), samples.all().size());
    for (std::size_t i = 0; i < series.samples.size(); ++i) EXPECT_EQ(series.samples[i].step, samples.all()[i].step);
    samples.cut(10);
    samples.put_into(series);
    EXPECT_EQ(series.samples.size(), samples.all().size());
}

TEST(RunSamples, of_a_view_are_those_of_now_whatever_happened_between) {
    RunSamples samples(1);
    SampleSeries series;
    const auto put_up_to = [&samples](std::uint64_t last) {
        const std::uint64_t first = samples.all().empty() ? 0 : samples.all().back().step + 1;
        for (std::uint64_t step = first; step <= last; ++step)
            samples.put(sample_of(step, static_cast<double>(step), {}));
    };
    const auto expect_all = [&] {
        samples.put_into(series);
        ASSERT_EQ(series.samples.size(), samples.all().size());
        for (std::size_t i = 0; i < series.samples.size(); ++i) {
            ASSERT_EQ(series.samples[i].step, samples.all()[i].step);
            ASSERT_EQ(series.samples[i].particle() != nullptr, samples.all()[i].particle() != nullptr);
        }
    };
    put_up_to(3000);
    expect_all();
    put_up_to(RunSamples::most + 10);  // every second one was left out meanwhile: more than the view has are left
    ASSERT_GT(samples.all().size(), 3000u);
    expect_all();
    samples.follow({0});
    expect_all();
    Sample known = samples.all()[5];
    known.particles = {Sample::Particle{}};
    samples.put(known);  // gone through again
    expect_all();
    EXPECT_TRUE(series.samples[5].particle());
}

// dt is twice the limit: it diverges, and is taken back to its last good step.
TEST(RunSamples, end_where_a_run_that_diverges_does) {
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 3, {}));
    session.advance(5000);
    ASSERT_TRUE(session.line().is_over());
    const auto samples = samples_of(session);
    ASSERT_FALSE(samples.empty());
    EXPECT_LE(samples.back().step, session.run().step());
    for (const Sample& sample : samples) EXPECT_TRUE(std::isfinite(sample.energy_error));
}

TEST(RunSamples, runs_beside_the_leading_one_have_theirs) {
    Session session = sampled(run_of("chain", "rk4", Precision::double_, 0.1, {}));
    session.handle(event::AddRun{run_of("chain", "euler", Precision::double_, 0.05, {})});
    session.advance(50);
    session.finish();
    SessionView view;
    session.observe(view);
    ASSERT_EQ(view.followers.size(), 1u);
    EXPECT_EQ(view.followers[0].series.samples.size(), 101u);
    session.handle(event::ShowSamples{false});
    session.finish();
    session.observe(view);
    EXPECT_TRUE(view.leading.series.samples.empty()) << "nothing is recorded that nobody looks at";
}

}  // namespace
}  // namespace steplab::test
