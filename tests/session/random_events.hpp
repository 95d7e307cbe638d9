#pragma once

#include "session/changed_run.hpp"
#include "session/session.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace steplab::test {

/// Random events, each at a random step.
class Visitor {
public:
    explicit Visitor(unsigned seed) : random_(seed) {}

    Event any(const Session& session) {
        const RunDescription& run = session.run().description();
        switch (below(14)) {
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
            case 9:
                return event::Do{Tug{1 + below(9), {number(), number(), 0}, 10 * number(), below(3) > 0, others()}};
            case 10:
                return event::Change{with_alterations(run, std::vector<Alteration>{alteration()})};
            default:
                return event::Step{static_cast<std::int64_t>(below(100))};
        }
    }
    /// Also those of several runs, and some that make them diverge.
    Event any_of_all(const Session& session) {
        const RunDescription& run = session.run().description();
        switch (below(20)) {
            case 0:
                return event::AddRun{with_method(run, below(2) == 0 ? "rk4" : "verlet")};
            case 1:
                return event::ChangeRun{1 + below(3), with(run, "dt", below(3) == 0 ? 2.5 : 0.02 + 0.1 * number())};
            case 2:
                return below(3) == 0 ? Event(event::Lead{1 + below(3)}) : Event(event::RemoveRun{below(4)});
            case 3:
                return event::TakeBranch{below(3)};
            case 4:
                return below(3) == 0 ? Event(event::Restart{}) : Event(event::Bookmark{"here"});
            case 5:
                return event::EqualCost{below(2) > 0};
            case 6:
                return event::Play{below(3) > 0};
            case 7:
                return event::SeekTime{number() * session.line().reached_time()};
            case 8:
                return event::Seek{session.line().reached() + below(50)};
            case 9:
                return event::Change{with(run, "dt", 2.5)};
            default:
                return any(session);
        }
    }
    std::uint64_t below(std::uint64_t n) { return random_() % n; }

private:
    ParticleList others() { return below(2) == 0 ? ParticleList() : ParticleList({below(10), below(10)}); }
    Alteration alteration() {
        const std::size_t particle = below(10);
        if (below(2) == 0) return {particle, below(2) == 0};
        return {particle, std::nullopt, 0.5 + number()};
    }
    double number() { return std::uniform_real_distribution(0.0, 1.0)(random_); }
    std::mt19937_64 random_;
};

}  // namespace steplab::test
