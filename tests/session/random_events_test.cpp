#include "session/random_events.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

void go_to(Session& session, std::uint64_t step) {
    session.handle(event::Seek{step});
    session.finish();
}

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
