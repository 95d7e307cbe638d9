#include "core/interruption.hpp"

#include "core/watching.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <unistd.h>

namespace steplab::test {
namespace {

// Each in a process of its own.
class InterruptionDeathTest : public testing::TestWithParam<int> {
protected:
    static void interrupt(int times) {
        catch_interruptions();
        for (int i = 0; i < times; ++i) std::raise(GetParam());
        try {
            check_interruption();
        } catch (const Interrupted&) {
            std::_Exit(7);
        }
        std::_Exit(0);
    }
};

TEST(InterruptibleBy, throws_once_asked_on_this_thread_while_it_lives) {
    std::atomic<bool> asked = false;
    {
        const InterruptibleBy interruptible(asked);
        EXPECT_NO_THROW(check_interruption());
        asked = true;
        EXPECT_THROW(check_interruption(), Interrupted);
        std::thread([] { EXPECT_NO_THROW(check_interruption()); }).join();
    }
    EXPECT_NO_THROW(check_interruption());
}

TEST(Watching, is_called_on_this_thread_while_it_lives_and_may_end_the_work) {
    int outer = 0, inner = 0;
    const Watching first([&] {
        ++outer;
        check_interruption();  // does not call it again
    });
    check_interruption();
    {
        const Watching second([&] {
            if (++inner == 2) throw std::runtime_error("enough");
        });
        check_interruption();
        EXPECT_THROW(check_interruption(), std::runtime_error);
        check_interruption();
    }
    std::thread(check_interruption).join();
    check_interruption();
    EXPECT_EQ(inner, 3);
    EXPECT_EQ(outer, 2);
}

TEST_P(InterruptionDeathTest, is_thrown_however_often_the_signal_comes) {
    EXPECT_EXIT(interrupt(0), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(interrupt(1), testing::ExitedWithCode(7), "");
    EXPECT_EXIT(interrupt(2), testing::ExitedWithCode(7), "");
}

/// Does not call check_interruption().
[[noreturn]] void be_deaf(int signal) {
    catch_interruptions();
    std::raise(signal);
    while (true) pause();
}

TEST_P(InterruptionDeathTest, ends_a_program_that_does_not_answer) {
    EXPECT_EXIT(be_deaf(GetParam()), testing::ExitedWithCode(128 + GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptionDeathTest, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace steplab::test
