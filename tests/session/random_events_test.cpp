#include "session/session.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription with(RunDescription run, std::string_view name, double value) {
    if (name == "dt") {
        run.dt = value;
    } else {
        run.scene.set(name, value);
    }
    return run;
}

void go_to(Session& session, std::uint64_t step) {
    session.handle(event::Seek{step});
    session.finish();
}

/// Random events, each at a random step.
class Visitor {
public:
    explicit Visitor(unsigned seed) : random_(seed) {}

    Event any(const Session& session) {
        const RunDescription& run = session.run().description();
        switch (below(12)) {
            case 0:
                return event::Do{Pull{1 + below(9), {number(), number(), 0}}};
            case 1:
                return event::Do{Kick{1 + below(9), {0.1 * number(), 0.1 * number(), 0}}};
            case 2:
                return event::Change{with(run, "dt", 0.02 + 0.05 * number())};
            case 3:
                return event::Change{with(run, "k", 0.5 + number())};
            case 4:
                return event::Change{with_method(run, below(2) == 0 ? "rk4" : "verlet")};
            case 5:
                return event::Do{TurnRound{}};
            case 6:
                return event::Seek{session.line().reached() - std::min(session.line().reached(), below(200))};
            case 7:
                if (below(4) > 0) return event::Step{30};
                return below(3) == 0 ? Event(event::Undo{}) : Event(event::Redo{});
            case 8:
                return event::Step{-static_cast<std::int64_t>(below(20))};
            default:
                return event::Step{static_cast<std::int64_t>(below(100))};
        }
    }
    std::uint64_t below(std::uint64_t n) { return random_() % n; }

private:
    double number() { return std::uniform_real_distribution(0.0, 1.0)(random_); }
    std::mt19937_64 random_;
};

// What the log says of a step is what was seen when the session stood there, however it came to stand there.
TEST(Session, ten_thousand_random_events_and_every_moment_again) {
    for (const Precision precision : precisions) {
        Session session(run_of("chain", "verlet", precision, 0.1));
        Visitor visitor(precision == Precision::float_ ? 1 : 2);
        std::map<std::uint64_t, std::string> seen;  // of the present way
        std::vector<SegmentBegin> way(session.line().changes().begin(), session.line().changes().end());
        for (int i = 0; i < 5000; ++i) {
            session.handle(visitor.any(session));
            session.finish();
            const auto now = session.line().changes();
            const auto [was, is] = std::mismatch(way.begin(), way.end(), now.begin(), now.end());
            std::uint64_t same = std::numeric_limits<std::uint64_t>::max();  // steps before this one
            if (was != way.end()) same = was->step;
            if (is != now.end()) same = std::min(same, is->step);
            seen.erase(seen.lower_bound(same), seen.end());
            way.assign(now.begin(), now.end());
            const auto [place, is_new] = seen.emplace(session.run().step(), session.run().hash());
            ASSERT_EQ(place->second, session.run().hash()) << "event " << i << ", step " << place->first;
        }
        ASSERT_GT(seen.size(), 100u);
        for (const auto& [step, hash] : seen) {
            go_to(session, step);
            ASSERT_EQ(session.run().hash(), hash) << "step " << step;
        }
        for (auto moment = seen.rbegin(); moment != seen.rend(); ++moment) {
            go_to(session, moment->first);
            ASSERT_EQ(session.run().hash(), moment->second) << "step " << moment->first;
        }
    }
}

}  // namespace
}  // namespace steplab::test
