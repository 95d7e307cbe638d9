#include "session/live_costs.hpp"

#include "core/helper_thread.hpp"
#include "core/interruption.hpp"
#include "core/problem_text.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

/// A view is due at most so often.
constexpr std::chrono::milliseconds between_views{200};

/// True if a scan of one is that of the other.
bool same_scan(const RunDescription& a, const RunDescription& b) {
    return a.model == b.model && a.origin == b.origin && a.scene == b.scene && a.start == b.start &&
           a.alterations == b.alterations;
}

}  // namespace

CostsView costs_of(const std::vector<RunDescription>& runs) {
    CostScan scan(runs.front());
    CostsView view{.time = scan.time()};
    while (auto point = scan.next()) put(view.points, std::move(*point));
    for (const RunDescription& run : runs) view.runs.push_back(scan.cost_of(run));
    view.complete = true;
    view.done = scan.done();
    view.how = scan.how();
    return view;
}

struct LiveCosts::Body {
    std::function<void()> ready;
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::vector<RunDescription> runs;  ///< asked for; none: nothing is
    std::uint64_t asked = 0;           ///< grows with every question
    std::shared_ptr<const CostsView> answer;
    std::shared_ptr<CostsView> without;  ///< the answer to the question if there is no memory for any, or no thread
    std::atomic<bool> given_up = false;  ///< what is under way is not wanted any more
    bool stopping = false;
    std::thread thread;

    // the thread's own
    std::uint64_t known = 0;  ///< the question that it is about
    RunDescription scene;
    std::optional<CostScan> scan;
    std::vector<RunDescription> shown;
    CostsView view;
    Clock::time_point told{};

    explicit Body(std::function<void()> call) : ready(std::move(call)) {}

    void loop() {
        const InterruptibleBy interruptible(given_up);
        while (true) {
            std::unique_lock lock(mutex);
            changed.wait(lock,
                         [this] { return stopping || asked != known || (scan && !view.complete && !runs.empty()); });
            if (stopping) return;
            known = asked;
            given_up = false;
            try {
                const std::vector<RunDescription> wanted = runs;
                lock.unlock();
                wanted.empty() ? scan.reset() : go_on(wanted);
            } catch (const Interrupted&) {  // something else is asked for
            } catch (const std::exception& problem) {
                if (lock.owns_lock()) lock.unlock();
                give_up(problem);
            }
        }
    }

    /// Tells why there is no more, with the points so far if there is memory for them. Throws nothing.
    void give_up(const std::exception& problem) {
        view.complete = true;
        view.how = problem_text(problem);
        try {
            tell(true);
        } catch (const std::exception&) {
            {
                const std::lock_guard lock(mutex);
                answer_without(std::move(view.how));
            }
            ready();
        }
    }

    /// The mutex is held.
    void answer_without(std::string why) {
        if (!without) return;
        without->complete = true;
        without->how = std::move(why);
        answer = std::exchange(without, nullptr);
    }

    void go_on(const std::vector<RunDescription>& wanted) {
        if (!scan || !same_scan(scene, wanted.front())) begin(wanted.front());
        if (shown != wanted) measure_shown(wanted);
        if (view.complete) return;
        const bool was_provisional = scan->provisional();
        auto point = scan->next();
        view.complete = !point;
        if (point) put(view.points, std::move(*point));
        if (was_provisional && !scan->provisional()) measure_shown(wanted);
        view.done = scan->done();
        view.how = scan->how();
        tell(view.complete || view.points.size() == 1);
    }

    void begin(const RunDescription& description) {
        scan.reset();
        scan.emplace(description);
        scene = description;
        shown.clear();
        view = {.time = scan->time()};
    }

    void measure_shown(const std::vector<RunDescription>& wanted) {
        view.runs.clear();
        for (const RunDescription& run : wanted) view.runs.push_back(scan->cost_of(run));
        view.provisional = scan->provisional();
        shown = wanted;
        tell(true);
    }

    void tell(bool at_once) {
        const auto now = Clock::now();
        if (!at_once && now - told < between_views) return;
        told = now;
        {
            const std::lock_guard lock(mutex);
            if (asked != known) return;
            answer = std::make_shared<const CostsView>(view);
        }
        ready();
    }
};

LiveCosts::LiveCosts(std::function<void()> ready) : body_(std::make_unique<Body>(std::move(ready))) {}

LiveCosts::~LiveCosts() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
        body_->given_up = true;
    }
    body_->changed.notify_one();
    if (body_->thread.joinable()) body_->thread.join();
}

void LiveCosts::ask(std::vector<RunDescription> runs) {
    {
        const std::lock_guard lock(body_->mutex);
        if (runs == body_->runs) return;
        const bool same = !body_->runs.empty() && !runs.empty() && same_scan(runs.front(), body_->runs.front());
        if (!same) body_->answer.reset();
        body_->without = std::make_shared<CostsView>();
        body_->given_up = !same;
        body_->runs = std::move(runs);
        ++body_->asked;
        const bool answered = body_->runs.empty() || has_thread(body_->thread, [body = body_.get()] { body->loop(); });
        if (!answered) {
            body_->answer_without(no_thread_text);
            body_->runs.clear();  // the next question is another one
        }
    }
    body_->changed.notify_one();
}

std::shared_ptr<const CostsView> LiveCosts::newest() const {
    const std::lock_guard lock(body_->mutex);
    return body_->answer;
}

void LiveCosts::forget() { ask({}); }

}  // namespace steplab
