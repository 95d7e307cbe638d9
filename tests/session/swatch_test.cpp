// Which colour and line is whose.

#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// "verlet 0, rk4 1": the methods of the runs with their swatches, the leading one first.
std::string swatches(const Session& session) {
    SessionView view;
    session.observe(view);
    std::string text = view.leading.description.method + " " + std::to_string(view.leading.swatch);
    for (const RunView& run : view.followers) text += ", " + run.description.method + " " + std::to_string(run.swatch);
    return text;
}

TEST(Swatches, stay_with_their_runs_whatever_happens_to_others) {
    Session session(chain("verlet"));
    EXPECT_EQ(swatches(session), "verlet 0");
    for (const char* const method : {"rk4", "stoermer", "forest-ruth"}) session.handle(event::AddRun{chain(method)});
    EXPECT_EQ(swatches(session), "verlet 0, rk4 1, stoermer 2, forest-ruth 3");
    session.handle(event::Lead{2});
    EXPECT_EQ(swatches(session), "stoermer 2, rk4 1, verlet 0, forest-ruth 3");
    session.handle(event::RemoveRun{1});
    EXPECT_EQ(swatches(session), "stoermer 2, verlet 0, forest-ruth 3");
    session.handle(event::ChangeRun{2, chain("euler")});
    EXPECT_EQ(swatches(session), "stoermer 2, verlet 0, euler 3");
    session.handle(event::Restart{});
    session.handle(event::Step{3});
    EXPECT_EQ(swatches(session), "stoermer 2, verlet 0, euler 3");
    session.handle(event::AddRun{chain("midpoint")});
    EXPECT_EQ(swatches(session), "stoermer 2, verlet 0, euler 3, midpoint 1") << "the one that is free";
    session.handle(event::RemoveRun{0});
    EXPECT_EQ(swatches(session), "verlet 0, euler 3, midpoint 1");
    session.handle(event::Lead{1});
    session.handle(event::Begin{chain("rk4")});
    EXPECT_EQ(swatches(session), "rk4 0");
    session.handle(event::AddRun{chain("euler")});
    session.handle(event::Lead{1});
    session.handle(event::Change{run_of("mesh", "euler", Precision::double_, 0.1)});
    EXPECT_EQ(swatches(session), "euler 0") << "alone on another scene";
}

TEST(Swatches, come_back_with_what_is_undone) {
    Session session(chain("verlet"));
    std::vector<std::string> seen{swatches(session)};
    const Event events[] = {event::AddRun{chain("rk4")}, event::Lead{1},      event::AddRun{chain("midpoint")},
                            event::RemoveRun{1},         event::RemoveRun{0}, event::Begin{chain("euler")}};
    for (const Event& event : events) {
        session.handle(event);
        seen.push_back(swatches(session));
    }
    const auto known = seen;
    EXPECT_EQ(known[2], "rk4 1, verlet 0");
    EXPECT_EQ(known[5], "midpoint 0") << "it is alone";
    for (; seen.size() > 1; seen.pop_back()) {
        EXPECT_EQ(swatches(session), seen.back());
        session.handle(event::Undo{});
    }
    for (const std::string& expected : known) {
        EXPECT_EQ(swatches(session), expected);
        session.handle(event::Redo{});
    }
}

TEST(Swatches, are_different_ones_after_any_events) {
    Session session(chain());
    std::mt19937 random(2008);
    const auto any = [&]() -> Event {
        const std::size_t runs = 1 + session.followers().size();
        const char* const methods[] = {"verlet", "rk4", "midpoint"};
        switch (random() % 8) {
            case 0:
            case 1:
                if (runs < Session::most_runs) return event::AddRun{chain(methods[random() % 3])};
                return event::Restart{};
            case 2:
                if (runs > 1) return event::RemoveRun{random() % runs};
                return event::Step{2};
            case 3:
            case 4:
                if (runs > 1) return event::Lead{1 + random() % (runs - 1)};
                return event::Change{
                    with(session.run().description(), "dt", 0.01 * static_cast<double>(1 + random() % 9))};
            case 5:
                return event::Redo{};
            default:
                return event::Undo{};
        }
    };
    std::size_t most = 0;
    for (int i = 0; i < 1000; ++i) {
        session.handle(any());
        SessionView view;
        session.observe(view);
        std::set<std::size_t> known{view.leading.swatch};
        for (const RunView& run : view.followers) known.insert(run.swatch);
        ASSERT_EQ(known.size(), 1 + view.followers.size()) << swatches(session) << " after event " << i;
        ASSERT_LT(*known.rbegin(), Session::most_runs);
        if (known.size() == 1) {
            ASSERT_EQ(*known.begin(), 0u) << "alone, after event " << i;
        }
        most = std::max(most, known.size());
    }
    EXPECT_EQ(most, Session::most_runs);
}

}  // namespace
}  // namespace steplab::test
