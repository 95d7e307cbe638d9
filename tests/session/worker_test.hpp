#pragma once

#include "session/worker.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace steplab::test {

/// Told by the worker when there is a new view: tests wait for what they expect to see, not for time to pass. A worker
/// can only call a plain function, so there is one for all tests, which run one after the other.
struct News {
    static inline std::mutex mutex;
    static inline std::condition_variable came;
    static inline bool something_new = false;

    static void wake() {
        {
            const std::lock_guard lock(mutex);
            something_new = true;
        }
        came.notify_one();
    }
    /// False if none came: the bound is for a broken worker only.
    static bool wait() {
        std::unique_lock lock(mutex);
        return came.wait_for(lock, std::chrono::seconds(60), [] { return std::exchange(something_new, false); });
    }
};

class WorkerTest : public testing::Test {
protected:
    explicit WorkerTest(const RunDescription& description = run_of("chain", "rk4", Precision::double_, 0.1))
        : worker(description) {
        worker.on_view(News::wake);
        worker.take(session);
    }

    /// Takes views until one fulfils the condition.
    template <class Condition>
    bool see(Condition condition) {
        while (true) {
            while (worker.take(session)) {
                if (condition(view)) return true;
            }
            if (!News::wait()) return false;
        }
    }

    Worker worker;
    SessionView session;
    RunView& view = session.leading;
};

}  // namespace steplab::test
