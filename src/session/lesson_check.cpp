#include "session/lesson_check.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "lab/study/distances.hpp"
#include "session/live_errors.hpp"
#include "session/replay.hpp"
#include "session/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace steplab {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t far = std::uint64_t{1} << 20;  ///< steps between two polls for an interruption

/// What is known of the runs of a session where they stand.
class Measured {
public:
    explicit Measured(Session& session) : session_(session) {
        while (session_.is_behind()) session_.catch_up([] { return false; });
        session_.observe(view_);
    }

    double of(const LessonFact& fact) {
        const double value = of(fact.quantity, fact.run);
        return fact.over ? value / of(fact.quantity, *fact.over) : value;
    }

private:
    const TimeLine& line(std::size_t run) const {
        return run == 0 ? session_.line() : session_.followers()[run - 1].line();
    }

    double of(const std::string& quantity, std::size_t number) {
        if (number > session_.followers().size()) return unknown;
        const Simulation& run = line(number).run();
        if (quantity == "steps") return static_cast<double>(run.step());
        if (quantity == "time") return run.time();
        if (quantity == "diverged") return run.divergence() ? 1 : 0;
        if (quantity == "evaluations") return static_cast<double>(run.evaluations());
        if (quantity == "energy error") return relative(run.diagnostics());
        if (quantity == "stability limit") return limit(run.description());
        if (quantity == "distance") return distance(run, session_.run());
        if (quantity == "distance from start")
            return distance(run, Simulation(line(number).changes().front().description));
        if (quantity == "largest energy error" || quantity == "largest displacement") return largest(quantity, number);
        return of_errors(quantity, number);
    }

    static double relative(double error, double energy) { return error / std::abs(energy - error); }
    static double relative(const Diagnostics& measured) {
        return relative(measured.energy_error, measured.kinetic + measured.potential);
    }
    static double limit(const RunDescription& run) {
        const auto limit = stability_limit(run);
        return limit ? limit->limit : unknown;
    }
    static double distance(const Simulation& a, const Simulation& b) {
        return largest_distance(a.state().displacement, b.state().displacement);
    }

    /// Over the samples of a run, which are those of its plots.
    double largest(const std::string& quantity, std::size_t number) const {
        const RunView& run = number == 0 ? view_.leading : view_.followers[number - 1];
        double largest = 0;
        for (const Sample& sample : run.series.samples) {
            const double value = quantity == "largest displacement"
                                     ? sample.largest_displacement
                                     : std::abs(relative(sample.energy_error, sample.kinetic + sample.potential));
            largest = std::max(largest, value);
        }
        return largest;
    }

    double of_errors(const std::string& quantity, std::size_t number) {
        const auto& runs = errors().runs;
        if (number >= runs.size() || !runs[number]) return unknown;
        if (quantity == "position error") return runs[number]->error;
        if (quantity == "phase error") return runs[number]->phase_error.value_or(unknown);
        return runs[number]->momentum_error.value_or(unknown);
    }

    /// As the window has them, computed once.
    const SessionErrors& errors() {
        if (errors_) return *errors_;
        LiveErrors live([] {});
        live.ask(session_.run().time(), shown_runs(session_));
        while (!(errors_ = live.newest(std::chrono::milliseconds(50)))) check_interruption();
        return *errors_;
    }

    Session& session_;
    SessionView view_;
    std::optional<SessionErrors> errors_;
};

/// The session of a lesson on its way through the pages.
class LessonCheck {
public:
    explicit LessonCheck(const Lesson& lesson)
        : lesson_(lesson), session_(lesson.session->start), replay_(*lesson.session, session_) {
        session_.handle(event::ShowSamples{true});
    }

    std::vector<CheckedFact> run() {
        for (std::size_t i = 0; i < lesson_.pages.size(); ++i) go_through(i);
        return std::move(checked_);
    }

private:
    void go_through(std::size_t page) {
        const LessonPage& now = lesson_.pages[page];
        std::size_t begin = checked_.size();
        for (const LessonFact& fact : now.facts) checked_.push_back({page, fact, unknown});
        const auto facts = std::span(checked_).subspan(begin);
        while (replay_.handled() < now.to) {
            check_interruption();
            measure(facts, session_.run().step());
            replay_.is_due() ? perform() : replay_.approach(to_next(facts));
        }
        measure(facts, std::nullopt);
    }

    void perform() {
        if (const auto difference = replay_.perform()) throw UsageError(*difference);
    }

    /// Steps to the next fact, or as many as are taken at a time.
    std::uint64_t to_next(std::span<const CheckedFact> facts) const {
        std::uint64_t next = far;
        for (const CheckedFact& each : facts) {
            const std::uint64_t step = each.fact.step.value_or(0), now = session_.run().step();
            if (step > now) next = std::min(next, step - now);
        }
        return next;
    }

    /// Those of this step; none: of the end of the page. What is known of an earlier passing stays.
    void measure(std::span<CheckedFact> facts, std::optional<std::uint64_t> step) {
        const auto is_due = [&](const CheckedFact& each) { return each.fact.step == step && std::isnan(each.value); };
        if (std::none_of(facts.begin(), facts.end(), is_due)) return;
        Measured measured(session_);
        for (CheckedFact& each : facts) {
            if (is_due(each)) each.value = measured.of(each.fact);
        }
    }

    const Lesson& lesson_;
    Session session_;
    Replay replay_;
    std::vector<CheckedFact> checked_;
};

}  // namespace

std::vector<CheckedFact> check_facts(const Lesson& lesson) { return LessonCheck(lesson).run(); }

}  // namespace steplab
