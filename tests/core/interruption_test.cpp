#include "core/interruption.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>

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

TEST_P(InterruptionDeathTest, is_thrown_the_first_time_and_ends_the_program_the_second) {
    EXPECT_EXIT(interrupt(0), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(interrupt(1), testing::ExitedWithCode(7), "");
    EXPECT_EXIT(interrupt(2), testing::KilledBySignal(GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptionDeathTest, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace steplab::test
