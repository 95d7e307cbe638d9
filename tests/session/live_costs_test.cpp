#include "session/live_costs.hpp"

#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <vector>

namespace steplab::test {
namespace {

/// Waits for what the thread has to say.
class Told {
public:
    void tell() {
        {
            const std::lock_guard lock(mutex_);
            ++count_;
        }
        changed_.notify_all();
    }
    /// Until `enough` says so of what is newest then.
    template <class Enough>
    std::shared_ptr<const CostsView> wait(const LiveCosts& costs, Enough enough) {
        std::unique_lock lock(mutex_);
        std::shared_ptr<const CostsView> newest;
        changed_.wait_for(lock, std::chrono::minutes(2), [&] {
            newest = costs.newest();
            return newest && enough(*newest);
        });
        return newest;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int count_ = 0;
};

RunDescription oscillator(double k = 1) { return run_of("oscillator", "rk4", Precision::double_, 0.1, {{"k", k}}); }

TEST(LiveCosts, are_those_of_a_scan_and_of_the_runs_that_are_shown) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    RunDescription other = with_method(oscillator(), "euler");
    costs.ask({oscillator(), other});
    const auto view = told.wait(costs, [](const CostsView& now) { return now.complete; });
    ASSERT_TRUE(view && view->complete);
    ASSERT_EQ(view->runs.size(), 2u);
    CostScan scan(oscillator());
    ASSERT_TRUE(view->runs[0] && view->runs[1]);
    EXPECT_EQ(view->runs[0]->error, scan.cost_of(oscillator())->error);
    EXPECT_EQ(view->runs[1]->evaluations, scan.cost_of(other)->evaluations);
    // series that time ends may differ in length, what both have does not
    const auto first = scan.next();
    ASSERT_TRUE(first);
    EXPECT_EQ(view->points.front().run, first->run);
    EXPECT_EQ(view->points.front().error, first->error);
    EXPECT_EQ(view->done, 1);
}

TEST(LiveCosts, of_another_scene_replace_those_of_before_at_once) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    costs.ask({oscillator()});
    told.wait(costs, [](const CostsView& now) { return !now.points.empty(); });
    costs.ask({oscillator(4)});
    const auto first = costs.newest();
    if (first && !first->points.empty()) {
        EXPECT_EQ(first->points.front().run.scene["k"], 4);
    }
    const auto view = told.wait(costs, [](const CostsView& now) { return !now.points.empty(); });
    ASSERT_TRUE(view && !view->points.empty());
    EXPECT_EQ(view->points.front().run.scene["k"], 4);
}

TEST(LiveCosts, of_a_heavier_particle_are_those_of_another_scene) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    costs.ask({oscillator()});
    told.wait(costs, [](const CostsView& now) { return !now.points.empty(); });
    const std::size_t last = Simulation(oscillator()).particles() - 1;
    const RunDescription heavy = with_alterations(oscillator(), std::vector<Alteration>{{last, std::nullopt, 4.0}});
    costs.ask({heavy});
    const auto first = costs.newest();
    if (first && !first->points.empty()) {
        EXPECT_EQ(first->points.front().run.alterations, heavy.alterations);
    }
    const auto view = told.wait(costs, [](const CostsView& now) { return !now.points.empty(); });
    ASSERT_TRUE(view && !view->points.empty());
    EXPECT_EQ(view->points.front().run.alterations, heavy.alterations);
}

TEST(LiveCosts, keep_their_points_when_a_run_changes) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    costs.ask({oscillator()});
    const auto before = told.wait(costs, [](const CostsView& now) { return now.points.size() > 20; });
    ASSERT_TRUE(before && before->points.size() > 20);
    costs.ask({with_method(oscillator(), "euler")});
    const auto after = told.wait(costs, [](const CostsView& now) {
        return !now.runs.empty() && now.runs[0] && now.runs[0]->run.method == "euler";
    });
    ASSERT_TRUE(after);
    EXPECT_GE(after->points.size(), before->points.size());
}

TEST(LiveCosts, end_at_once_in_the_middle_of_a_reference) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    costs.ask({run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 60}})});
    costs.ask({oscillator()});
    const auto view = told.wait(costs, [](const CostsView& now) { return !now.points.empty(); });
    ASSERT_TRUE(view && !view->points.empty());
    EXPECT_EQ(view->points.front().run.model, "oscillator");
    costs.forget();
    EXPECT_FALSE(costs.newest());
}

TEST(LiveCosts, say_why_nothing_is_known) {
    Told told;
    LiveCosts costs([&] { told.tell(); });
    RunDescription impossible = oscillator();
    impossible.model = "none";
    costs.ask({impossible});
    const auto view = told.wait(costs, [](const CostsView& now) { return now.complete; });
    ASSERT_TRUE(view);
    EXPECT_TRUE(view->points.empty());
    EXPECT_FALSE(view->how.empty());
}

}  // namespace
}  // namespace steplab::test
