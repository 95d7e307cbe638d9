#include "session/live_errors.hpp"

#include "core/interruption.hpp"
#include "lab/study/reference_motion.hpp"
#include "session/session.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace steplab {

struct LiveErrors::Body {
    struct Question {
        double time = 0;
        std::vector<Shown> runs;
    };

    std::function<void()> ready;
    std::mutex mutex;
    std::condition_variable asked, answered;
    std::optional<Question> question;
    std::optional<SessionErrors> answer;
    std::uint64_t forgotten = 0;  ///< grows with every forget()
    bool busy = false;
    std::atomic<bool> stopping = false;
    std::vector<ReferenceMotion> motions;  ///< the thread's own: of each run
    std::thread thread;

    explicit Body(std::function<void()> call) : ready(std::move(call)) {
        thread = std::thread([this] { loop(); });
    }

    void loop() {
        const InterruptibleBy interruptible(stopping);
        while (true) {
            std::unique_lock lock(mutex);
            busy = false;
            answered.notify_all();
            asked.wait(lock, [this] { return stopping || question; });
            if (stopping) return;
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

    /// None if it was interrupted; without errors, but with the reason, if the reference cannot be computed.
    std::optional<SessionErrors> errors_of(const Question& of) {
        try {
            SessionErrors errors{.time = of.time, .runs = {}, .how = {}};
            while (motions.size() > of.runs.size()) motions.pop_back();
            for (std::size_t i = 0; i < of.runs.size(); ++i) errors.runs.push_back(compared_run(of.runs, i));
            if (!motions.empty()) errors.how = motions.front().how();
            errors.exact = !motions.empty() && motions.front().is_exact();
            return errors;
        } catch (const Interrupted&) {
            return std::nullopt;
        } catch (const std::exception& problem) {  // as a rule because there is no memory left
            motions.clear();
            return SessionErrors{.time = of.time, .runs = {}, .how = problem.what()};
        }
    }

    std::optional<Compared> compared_run(const std::vector<Shown>& runs, std::size_t number) {
        const Shown& run = runs[number];
        if (number == motions.size()) motions.emplace_back(run.changes.front().description);
        motions[number].follow(run.changes);
        if (run.over) return std::nullopt;
        const ReferenceMoment there = motions[number].at(run.moment.time);
        return compared(run.moment, there, motions[number].is_exact());
    }
};

LiveErrors::LiveErrors(std::function<void()> ready) : body_(std::make_unique<Body>(std::move(ready))) {}

LiveErrors::~LiveErrors() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
    }
    body_->asked.notify_one();
    body_->thread.join();
}

void LiveErrors::ask(double time, std::vector<Shown> runs) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->question = {time, std::move(runs)};
    }
    body_->asked.notify_one();
}

std::optional<SessionErrors> LiveErrors::newest(std::chrono::duration<double> most) {
    std::unique_lock lock(body_->mutex);
    body_->answered.wait_for(lock, most, [this] { return !body_->busy && !body_->question; });
    return body_->answer;
}

void LiveErrors::forget() {
    const std::lock_guard lock(body_->mutex);
    body_->question.reset();
    body_->answer.reset();
    ++body_->forgotten;
}

std::vector<LiveErrors::Shown> shown_runs(const Session& session) {
    const auto shown = [](const TimeLine& line) {
        return LiveErrors::Shown{
            moment_of(line.run(), line.start_momentum()), {line.past().begin(), line.past().end()}, line.is_over()};
    };
    std::vector<LiveErrors::Shown> runs{shown(session.line())};
    for (const FollowerRun& follower : session.followers()) runs.push_back(shown(follower.line()));
    return runs;
}

}  // namespace steplab
