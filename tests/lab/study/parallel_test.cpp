#include "lab/study/parallel.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

namespace steplab::test {
namespace {

/// How often each was called, and the number of threads for its run.
struct Called {
    std::vector<int> times;
    std::vector<std::size_t> threads;
};
Called called(std::size_t count, double bytes) {
    Called all{std::vector<int>(count), std::vector<std::size_t>(count)};
    std::mutex mutex;
    parallel_for_each(count, bytes, [&](std::size_t i, const Execution& execution) {
        const std::lock_guard lock(mutex);
        ++all.times[i];
        all.threads[i] = execution.threads;
    });
    return all;
}

TEST(ParallelForEach, does_each_once_and_shares_the_processors) {
    EXPECT_TRUE(called(0, 0).times.empty());
    for (const std::size_t count : {std::size_t(1), std::size_t(2), std::size_t(3), 2 * processors() + 1}) {
        const Called all = called(count, 0);
        EXPECT_EQ(all.times, std::vector<int>(count, 1));
        const std::size_t members = std::min(count, processors());
        for (const std::size_t threads : all.threads) EXPECT_EQ(threads, processors() / members);
    }
}

// One after the other, each with all processors.
TEST(ParallelForEach, runs_no_more_in_parallel_than_fit_into_memory) {
    for (const double share : {0.6, 1.0, 10.0}) {
        const Called all = called(5, share * available_memory());
        EXPECT_EQ(all.times, std::vector<int>(5, 1));
        for (const std::size_t threads : all.threads) EXPECT_EQ(threads, processors());
    }
}

// Every call fails, so that each thread begins at most one, however the processors are shared.
TEST(ParallelForEach, ends_with_the_first_exception) {
    std::atomic<std::size_t> begun = 0;
    const auto fail = [&](std::size_t, const Execution&) {
        ++begun;
        throw UsageError("enough");
    };
    EXPECT_THROW(parallel_for_each(1000, 0, fail), UsageError);
    EXPECT_LE(begun, processors());
}

}  // namespace
}  // namespace steplab::test
