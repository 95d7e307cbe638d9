#include "session/live_verdict.hpp"

#include "core/helper_thread.hpp"
#include "core/interruption.hpp"
#include "session/share.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

/// Of the time of one processor; a blow-up, after which nothing runs, has all of it.
constexpr double part_for_moments = 0.1;
/// A read-out that changes more often cannot be read.
constexpr std::chrono::milliseconds between_answers{100};
constexpr std::chrono::seconds longest_wait{2};

constexpr const char* no_memory_text = "there is not enough memory to find the cause";

/// What is known of a blow-up that cannot be studied.
std::shared_ptr<const BlowUp> unexplained(const Divergence& divergence, const char* why) {
    BlowUp known;
    known.divergence = divergence;
    known.step = divergence.step;
    known.why = why;
    known.complete = true;
    return std::make_shared<const BlowUp>(std::move(known));
}

}  // namespace

struct LiveVerdict::Body {
    /// Which blow-up is to be explained.
    struct Why {
        std::vector<SegmentBegin> changes;
        Divergence divergence;
        std::vector<ReplayedRun::Moment> kept;
        std::shared_ptr<const BlowUp> alone;  ///< what is known without a study, if there is no memory for more
    };

    std::function<void()> ready;
    mutable std::mutex mutex;
    std::condition_variable changed, told;
    std::shared_ptr<const Moment> moment;                                ///< to be answered
    RunDescription newest_run;                                           ///< asked about last
    std::optional<std::pair<std::uint64_t, std::uint64_t>> newest_step;  ///< its segment and step
    std::shared_ptr<const Why> wanted;                                   ///< null: none
    std::shared_ptr<const PresentLimit> limit;
    std::shared_ptr<const BlowUp> blow_up;
    std::atomic<bool> given_up = false;  ///< the study under way is not wanted any more
    bool stopping = false;
    std::thread thread;

    // the thread's own
    PresentLimits limits;
    std::shared_ptr<const Why> studied;
    std::optional<BlowUpStudy> study;
    bool complete = true;  ///< nothing is left to be studied
    Share share{part_for_moments, longest_wait};
    Clock::time_point answered{};

    explicit Body(std::function<void()> call) : ready(std::move(call)) {}

    /// What is shown of another dt or method is wrong until there is an answer.
    bool is_urgent() const { return moment && !limit; }
    bool has_study() const { return wanted && (wanted != studied || !complete); }
    bool is_due() const { return share.due(Clock::now()) && Clock::now() >= answered + between_answers; }

    void wait(std::unique_lock<std::mutex>& lock) {
        while (!stopping && !has_study()) {
            if (!moment) {
                changed.wait(lock);
            } else if (!is_urgent() && !is_due()) {
                changed.wait_for(lock, between_answers / 4);
            } else {
                return;
            }
        }
    }

    void loop() {
        const InterruptibleBy interruptible(given_up);
        while (true) {
            std::unique_lock lock(mutex);
            wait(lock);
            if (stopping) return;
            given_up = false;
            const auto asked = has_study() ? nullptr : std::exchange(moment, nullptr);
            try {
                asked ? answer(lock, *asked) : go_on(lock, wanted);
            } catch (const Interrupted&) {
                if (!given_up) return;  // the program ends
                if (!lock.owns_lock()) lock.lock();
                if (!moment && asked && asked->run == newest_run) moment = asked;
            } catch (const std::exception&) {  // as a rule there is no memory left
                if (!lock.owns_lock()) lock.lock();
                if (give_up_study()) {
                    lock.unlock();
                    ready();
                }
            }
        }
    }

    /// What is known of the blow-up is all there will be. False if none is studied. The mutex is held.
    bool give_up_study() noexcept {
        complete = true;
        study.reset();
        if (!wanted || wanted != studied) return false;
        try {
            BlowUp known = blow_up ? *blow_up : *wanted->alone;
            known.complete = true;
            blow_up = std::make_shared<const BlowUp>(std::move(known));
        } catch (const std::exception&) {
            blow_up = wanted->alone;
        }
        return true;
    }

    void go_on(std::unique_lock<std::mutex>& lock, std::shared_ptr<const Why> why) {
        lock.unlock();
        if (why != studied) {
            complete = false;
            study.reset();
            studied = why;
            study.emplace(why->changes, why->divergence, why->kept);
        }
        complete = !study->next();
        auto found = std::make_shared<const BlowUp>(study->found());
        if (complete) study.reset();  // with its states of the scene
        lock.lock();
        if (wanted != why) return;
        blow_up = std::move(found);
        lock.unlock();
        ready();
    }

    void answer(std::unique_lock<std::mutex>& lock, const Moment& asked) {
        lock.unlock();
        const auto begin = Clock::now();
        auto found = std::make_shared<const PresentLimit>(limits.at(asked.run, asked.state, asked.step, asked.time));
        answered = Clock::now();
        share.took(begin, answered);
        lock.lock();
        if (newest_run != asked.run) return;
        limit = std::move(found);
        lock.unlock();
        told.notify_all();
        ready();
    }

    bool has_thread() {
        return steplab::has_thread(thread, [this] { loop(); });
    }

    /// On the thread that asks, as there is none for it: a part of its time, too, is all that this takes.
    void answer_here(std::unique_lock<std::mutex>& lock) {
        if (!is_urgent() && !is_due()) return;
        const auto asked = std::exchange(moment, nullptr);
        try {
            answer(lock, *asked);
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception&) {  // the limit at rest is shown
        }
    }
};

LiveVerdict::LiveVerdict(std::function<void()> ready) : body_(std::make_unique<Body>(std::move(ready))) {}

LiveVerdict::~LiveVerdict() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
        body_->given_up = true;
    }
    body_->changed.notify_one();
    if (body_->thread.joinable()) body_->thread.join();
}

void LiveVerdict::ask(Moment moment) {
    std::unique_lock lock(body_->mutex);
    if (body_->newest_run != moment.run) body_->limit.reset();
    body_->newest_run = moment.run;
    body_->newest_step = {moment.segment, moment.step};
    body_->moment = std::make_shared<const Moment>(std::move(moment));
    if (!body_->has_thread()) return body_->answer_here(lock);
    lock.unlock();
    body_->changed.notify_one();
}

bool LiveVerdict::is_new(const Simulation& run) const {
    const std::lock_guard lock(body_->mutex);
    return body_->newest_step != std::pair(run.segment(), run.step()) || body_->newest_run != run.description();
}

void LiveVerdict::ask_why(const TimeLine& line, const Divergence& divergence) {
    {
        const std::lock_guard lock(body_->mutex);
        const auto& now = body_->wanted;
        const auto changes = line.past();
        if (now && now->divergence.step == divergence.step &&
            std::equal(changes.begin(), changes.end(), now->changes.begin(), now->changes.end()))
            return;
        body_->wanted = std::make_shared<const Body::Why>(Body::Why{{changes.begin(), changes.end()},
                                                                    divergence,
                                                                    line.kept_moments(),
                                                                    unexplained(divergence, no_memory_text)});
        body_->blow_up = body_->has_thread() ? nullptr : unexplained(divergence, no_thread_text);
        body_->given_up = true;
    }
    body_->changed.notify_one();
}

void LiveVerdict::forget_why() {
    const std::lock_guard lock(body_->mutex);
    if (!body_->wanted) return;
    body_->wanted.reset();
    body_->blow_up.reset();
    body_->given_up = true;
}

std::shared_ptr<const PresentLimit> LiveVerdict::limit(std::chrono::duration<double> most) const {
    std::unique_lock lock(body_->mutex);
    if (body_->thread.joinable()) body_->told.wait_for(lock, most, [this] { return body_->limit != nullptr; });
    return body_->limit;
}

std::shared_ptr<const BlowUp> LiveVerdict::blow_up() const {
    const std::lock_guard lock(body_->mutex);
    return body_->blow_up;
}

}  // namespace steplab
