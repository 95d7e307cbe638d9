#include "session/live_errors.hpp"

#include "core/helper_thread.hpp"
#include "core/interruption.hpp"
#include "core/problem_text.hpp"
#include "lab/study/reference_motion.hpp"
#include "session/session.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

/// While samples come, views of them are no more often.
constexpr std::chrono::milliseconds between_error_views{100};

}  // namespace

struct LiveErrors::Body {
    struct Question {
        double time = 0;
        std::vector<Shown> runs;
    };

    /// A run is compared at the moments that are asked for, and at the steps of a grid where that is wanted.
    struct Followed {
        std::unique_ptr<ReferenceMotion> motion = {};
        std::unique_ptr<ErrorSamples> samples = {};
    };

    std::function<void()> ready;
    mutable std::mutex mutex;
    std::condition_variable asked, answered;
    std::optional<Question> question;
    std::optional<SessionErrors> answer;
    std::uint64_t forgotten = 0;  ///< grows with every forget()
    bool busy = false, unwanted = false;
    std::atomic<bool> stopping = false;
    std::vector<Followed> runs;  ///< the thread's own, which holds the mutex to change what there is
    Clock::time_point shown{};   ///< when there were more samples to see
    std::thread thread;

    explicit Body(std::function<void()> call) : ready(std::move(call)) {}

    bool has_due_samples() const {
        return std::any_of(runs.begin(), runs.end(),
                           [](const Followed& run) { return run.samples && run.samples->is_due(); });
    }

    void loop() {
        const InterruptibleBy interruptible(stopping);
        while (true) {
            std::unique_lock lock(mutex);
            busy = false;
            answered.notify_all();
            if (std::exchange(unwanted, false)) runs.clear();
            asked.wait(lock, [this] { return stopping || question || unwanted || has_due_samples(); });
            if (stopping) return;
            if (unwanted) continue;
            if (!question) {
                lock.unlock();
                take_samples();
                continue;
            }
            busy = true;
            const Question taken = *std::exchange(question, std::nullopt);
            const std::uint64_t then = forgotten;
            lock.unlock();
            std::optional<SessionErrors> found = errors_of(taken);
            lock.lock();
            if (!found || then != forgotten) continue;
            answer = std::move(found);
            busy = false;
            lock.unlock();
            answered.notify_all();
            ready();
        }
    }

    /// One of each run. What cannot be computed is not asked for again.
    void take_samples() {
        for (Followed& run : runs) {
            try {
                if (run.samples && run.samples->is_due()) run.samples->take();
            } catch (const Interrupted&) {
                return;
            } catch (const std::exception&) {
                drop(run);
            }
        }
        if (has_due_samples() && Clock::now() < shown + between_error_views) return;
        shown = Clock::now();
        ready();
    }

    void drop(Followed& run) {
        const std::lock_guard lock(mutex);
        run.samples.reset();
    }

    /// None if it was interrupted; without errors, but with the reason, if the reference cannot be computed.
    std::optional<SessionErrors> errors_of(const Question& of) {
        try {
            SessionErrors errors{.time = of.time, .runs = {}, .how = {}};
            follow(of.runs);
            for (std::size_t i = 0; i < of.runs.size(); ++i) {
                ReferenceMotion& motion = motion_of(runs[i], of.runs[i]);
                errors.runs.push_back(compared_run(of.runs[i], motion));
                if (i > 0) continue;
                errors.how = motion.how();
                errors.exact = motion.is_exact();
            }
            return errors;
        } catch (const Interrupted&) {
            return std::nullopt;
        } catch (const std::exception& problem) {  // as a rule because there is no memory left
            const std::lock_guard lock(mutex);
            runs.clear();
            return SessionErrors{.time = of.time, .runs = {}, .how = problem_text(problem)};
        }
    }

    /// Those that were asked about.
    void follow(const std::vector<Shown>& shown_ones) {
        {
            const std::lock_guard lock(mutex);
            runs.resize(shown_ones.size());
        }
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const auto& way = shown_ones[i].way;
            const bool fits = way && runs[i].samples && runs[i].samples->begins_with(way->changes.front().description);
            if (!fits && runs[i].samples) drop(runs[i]);
            if (way && !fits) {
                auto begun = std::make_unique<ErrorSamples>(way->changes.front().description);
                const std::lock_guard lock(mutex);
                runs[i].samples = std::move(begun);
            }
            if (way) runs[i].samples->follow(way->changes, way->reached);
        }
    }

    /// That of the samples where they are as far as the run: a second one need not be computed.
    static ReferenceMotion& motion_of(Followed& run, const Shown& shown) {
        if (run.samples && run.samples->is_beside(shown.moment.step)) {
            run.motion.reset();
            return run.samples->motion();
        }
        if (!run.motion) run.motion = std::make_unique<ReferenceMotion>(shown.changes.front().description);
        return *run.motion;
    }

    static std::optional<Compared> compared_run(const Shown& run, ReferenceMotion& motion) {
        motion.follow(run.changes);
        if (run.over) return std::nullopt;
        const ReferenceMoment there = motion.at(run.moment.time);
        return compared(run.moment, there, motion.is_exact());
    }
};

LiveErrors::LiveErrors(std::function<void()> ready) : body_(std::make_unique<Body>(std::move(ready))) {}

LiveErrors::~LiveErrors() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
    }
    body_->asked.notify_one();
    if (body_->thread.joinable()) body_->thread.join();
}

void LiveErrors::ask(double time, std::vector<Shown> runs) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->unwanted = false;
        if (has_thread(body_->thread, [body = body_.get()] { body->loop(); })) {
            body_->question = {time, std::move(runs)};
        } else {
            body_->answer = SessionErrors{.time = time, .runs = {}, .how = no_thread_text};
        }
    }
    body_->asked.notify_one();
}

std::optional<SessionErrors> LiveErrors::newest(std::chrono::duration<double> most) {
    std::unique_lock lock(body_->mutex);
    body_->answered.wait_for(lock, most, [this] { return !body_->busy && !body_->question; });
    return body_->answer;
}

void LiveErrors::put_into(std::vector<ErrorSeries>& series) const {
    const std::lock_guard lock(body_->mutex);
    series.resize(body_->runs.size());
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& samples = body_->runs[i].samples;
        samples ? samples->put_into(series[i]) : void(series[i] = {});
    }
}

void LiveErrors::forget() {
    const std::lock_guard lock(body_->mutex);
    body_->question.reset();
    body_->answer.reset();
    ++body_->forgotten;
    body_->unwanted = !body_->runs.empty();
    if (body_->unwanted) body_->asked.notify_one();
}

std::vector<LiveErrors::Shown> shown_runs(const Session& session) {
    const auto shown = [&](const TimeLine& line) {
        LiveErrors::Shown run{
            moment_of(line.run(), line.start_momentum()), {line.past().begin(), line.past().end()}, line.is_over()};
        if (session.takes_samples()) run.way = {{line.changes().begin(), line.changes().end()}, line.reached()};
        return run;
    };
    std::vector<LiveErrors::Shown> runs{shown(session.line())};
    for (const FollowerRun& follower : session.followers()) runs.push_back(shown(follower.line()));
    return runs;
}

}  // namespace steplab
