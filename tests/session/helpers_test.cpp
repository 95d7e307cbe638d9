// What threads beside a run say where there is no memory, not even in their handlers, or no thread at all.
#include "core/helper_thread.hpp"
#include "core/problem_text.hpp"
#include "session/live_costs.hpp"
#include "session/live_errors.hpp"
#include "session/live_verdict.hpp"
#include "session/session.hpp"
#include "session/worker_test.hpp"
#include "support/allocations.hpp"
#include "support/no_threads.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace steplab::test {
namespace {

/// Asks again with each word of a helper's, which takes no memory.
template <class Answer>
auto awaited(const Answer& answer) {
    auto found = answer();
    while (!found && News::wait()) found = answer();
    return found;
}

RunDescription plain_chain(double dt = 0.1) { return run_of("chain", "rk4", Precision::double_, dt); }

/// At its end: rk4 is not stable at this dt.
TimeLine blown_up() {
    TimeLine line(plain_chain(2));
    while (!line.is_over()) line.advance(100);
    return line;
}

std::vector<LiveErrors::Shown> shown_at(const TimeLine& line) {
    return {{moment_of(line.run(), line.start_momentum()), {line.past().begin(), line.past().end()}, line.is_over()}};
}

TEST(ProblemText, is_there_without_memory) {
    const std::runtime_error problem(std::string(200, 'x'));
    EXPECT_EQ(problem_text(problem), problem.what());
    std::string text;
    {
        const NoLargerThan nothing(0);
        text = problem_text(problem);
    }
    EXPECT_EQ(text, "out of memory");
    EXPECT_EQ(problem_text(std::bad_alloc()), "out of memory");
}

TEST(HelpersWithoutMemory, tell_no_cause_of_a_blow_up_but_that_there_is_none) {
    const TimeLine line = blown_up();
    LiveVerdict verdict(News::wake);
    std::shared_ptr<const BlowUp> found;
    {
        const NoMemoryElsewhere none;
        verdict.ask_why(line, *line.run().divergence());
        found = awaited([&] { return verdict.blow_up(); });
    }
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->complete);
    EXPECT_EQ(found->divergence.step, line.step());
    EXPECT_EQ(found->why, "there is not enough memory to find the cause");
}

TEST(HelpersWithoutMemory, have_memory_again_for_what_is_asked_later) {
    const TimeLine line = blown_up();
    const Simulation& run = line.run();
    LiveVerdict verdict(News::wake);
    {
        const NoMemoryElsewhere none;
        verdict.ask_why(line, *run.divergence());
        ASSERT_TRUE(awaited([&] { return verdict.blow_up(); }));
    }
    verdict.forget_why();
    verdict.ask_why(line, *run.divergence());
    const auto found = awaited([&] {
        auto now = verdict.blow_up();
        return now && now->complete ? now : nullptr;
    });
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->tried.empty());
}

TEST(HelpersWithoutMemory, say_so_in_place_of_errors_and_costs) {
    const TimeLine line(plain_chain());
    LiveErrors errors(News::wake);
    LiveCosts costs(News::wake);
    std::shared_ptr<const CostsView> found;
    std::optional<SessionErrors> compared;
    {
        const NoMemoryElsewhere none;
        costs.ask({plain_chain()});
        found = awaited([&] { return costs.newest(); });
        errors.ask(0, shown_at(line));
        compared = awaited([&] { return errors.newest(std::chrono::seconds(0)); });
    }
    ASSERT_TRUE(found && compared);
    EXPECT_TRUE(found->complete);
    EXPECT_EQ(found->how, "out of memory");
    EXPECT_TRUE(compared->runs.empty());
    EXPECT_EQ(compared->how, "out of memory");
}

TEST_F(WorkerTest, lives_on_where_there_is_no_memory_at_all) {
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
    {
        const NoMemoryElsewhere none;
        worker.send(event::Step{1});
        ASSERT_TRUE(see([](const RunView& v) { return !v.error.empty(); }));
    }
    EXPECT_EQ(view.error, "out of memory");
    worker.send(event::Restart{});
    worker.send(event::Step{2});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 2 && v.error.empty(); }));
}

TEST(HelpersWithoutThreads, say_so_in_place_of_their_results) {
    const TimeLine line = blown_up();
    LiveVerdict verdict(News::wake);
    LiveErrors errors(News::wake);
    LiveCosts costs(News::wake);
    {
        const NoThreads none;
        verdict.ask_why(line, *line.run().divergence());
        errors.ask(0, shown_at(line));
        costs.ask({plain_chain()});
    }
    ASSERT_TRUE(verdict.blow_up() && costs.newest());
    EXPECT_EQ(verdict.blow_up()->why, no_thread_text);
    EXPECT_TRUE(verdict.blow_up()->complete);
    const auto compared = errors.newest(std::chrono::seconds(60));
    ASSERT_TRUE(compared);
    EXPECT_EQ(compared->how, no_thread_text);
    EXPECT_EQ(costs.newest()->how, no_thread_text);
    EXPECT_TRUE(costs.newest()->complete);
}

TEST(HelpersWithoutThreads, work_once_there_are_some) {
    const TimeLine line(plain_chain());
    LiveErrors errors(News::wake);
    LiveCosts costs(News::wake);
    {
        const NoThreads none;
        errors.ask(0, shown_at(line));
        costs.ask({plain_chain()});
    }
    errors.ask(0, shown_at(line));
    const auto compared = errors.newest(std::chrono::seconds(60));
    ASSERT_TRUE(compared);
    EXPECT_EQ(compared->runs.size(), 1u);
    costs.ask({plain_chain()});
    EXPECT_TRUE(awaited([&] {
        const auto now = costs.newest();
        return now && !now->points.empty();
    }));
}

TEST(HelpersWithoutThreads, know_the_present_limit_all_the_same) {
    const Simulation run(plain_chain());
    LiveVerdict verdict(News::wake);
    {
        const NoThreads none;
        verdict.ask({run.description(), run.step(), run.segment(), run.time(), run.state()});
    }
    const auto limit = verdict.limit(std::chrono::seconds(0));
    ASSERT_TRUE(limit);
    EXPECT_EQ(limit->limit, PresentLimits().at(run.description(), run.state(), run.step(), run.time()).limit);
}

TEST(HelperThread, is_started_once_where_there_is_one) {
    std::thread thread;
    {
        const NoThreads none;
        EXPECT_FALSE(has_thread(thread, [] {}));
    }
    EXPECT_TRUE(has_thread(thread, [] {}));
    EXPECT_TRUE(has_thread(thread, [] { FAIL() << "a second one"; }));
    thread.join();
}

}  // namespace
}  // namespace steplab::test
