#include "sim/worker.hpp"

#include "sim/companions.hpp"
#include "sim/history.hpp"
#include "sim/pace.hpp"
#include "sim/share.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

/// Computing between two looks at the commands: short enough that a change is felt at once.
constexpr Pace::Duration slice{0.008};
/// A view that nobody has taken yet is replaced by a newer one after this time.
constexpr Pace::Duration stale{0.05};
/// Of the time of a run that has none to spare: for views, and for moments to come back to.
constexpr double part_for_views = 0.03, part_for_history = 0.01;
/// But a picture that moves less often than this is of no use to who watches.
constexpr std::chrono::milliseconds longest_without_view{500};

}  // namespace

struct Worker::Body {
    // shared between the threads
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void(Body&)>> commands;
    std::optional<RunDescription> wanted;  // the newest change asked for; older ones it overtook are never computed
    bool stopping = false;
    bool fresh = false;  // `ready` has not been taken yet
    RunView ready;
    void (*wake)() = nullptr;

    // the worker's own
    Simulation simulation;
    History history;
    Pace pace;
    Rate rate;
    bool playing = false;
    std::optional<std::size_t> tracked;
    std::vector<SegmentBegin> segments;  // of the run so far
    Cloud cloud;
    std::optional<Companions> companions;
    std::uint64_t run = 0;
    std::string error;
    RunView view;
    Clock::time_point published;
    Share views{part_for_views, longest_without_view}, moments{part_for_history};
    std::thread thread;

    explicit Body(const RunDescription& description) : simulation(description), segments{{0, description}} {
        history.offer(simulation);
        publish();
        thread = std::thread([this] { loop(); });
    }

    void post(std::function<void(Body&)> command) {
        {
            const std::lock_guard lock(mutex);
            commands.push_back(std::move(command));
        }
        changed.notify_one();
    }

    void loop();
    void wait_for_work();
    bool carry_out_commands();
    void take_steps();
    bool companions_are_behind() const { return companions && !companions->are_at(simulation.step(), segments); }
    void bring_companions(Pace::Duration most);
    void keep_moment();
    bool affordable() const;
    void publish();
    void show_cloud(Cloud asked);
    void step_back();
    void pull(std::size_t particle, Vec3 position);
    void apply(const RunDescription& description);
    void begin_anew();
    void play(bool on);
};

void Worker::Body::loop() {
    while (true) {
        wait_for_work();
        {
            const std::lock_guard lock(mutex);
            if (stopping) return;
        }
        const bool told = carry_out_commands();
        const std::uint64_t before = simulation.step();
        const bool behind = companions_are_behind();
        if (behind) bring_companions(slice);
        if (playing) take_steps();
        if (told || ((behind || simulation.step() != before || simulation.divergence()) && affordable())) publish();
    }
}

void Worker::Body::wait_for_work() {
    std::unique_lock lock(mutex);
    if (companions_are_behind()) return;
    const auto called = [this] { return stopping || !commands.empty() || wanted; };
    if (!playing) return changed.wait(lock, called);
    changed.wait_until(lock, pace.next_due(Clock::now(), rate, simulation.dt()), called);
}

bool Worker::Body::carry_out_commands() {
    std::deque<std::function<void(Body&)>> taken;
    std::optional<RunDescription> description;
    {
        const std::lock_guard lock(mutex);
        taken.swap(commands);
        description = std::exchange(wanted, std::nullopt);
    }
    if (taken.empty() && !description) return false;
    error.clear();
    try {
        if (description) apply(*description);
        for (const auto& command : taken) command(*this);
    } catch (const std::exception& problem) {
        error = problem.what();
    }
    return true;
}

/// The companions go where the run stands, which may take longer where they begin: then the run waits for them.
void Worker::Body::bring_companions(Pace::Duration most) {
    const auto begin = Clock::now();
    try {
        companions->go_to(simulation.step(), segments, [&] { return Clock::now() - begin > most; });
    } catch (const std::exception& problem) {
        error = problem.what();
        show_cloud({});
    }
    pace.begin(Clock::now());
}

/// Of the run and its companions alike, so that they stay together.
void Worker::Body::take_steps() {
    if (companions_are_behind()) return;
    const auto begin = Clock::now();
    const std::uint64_t due = pace.steps_due(begin, rate, simulation.dt(), slice);
    if (due == 0) return;
    const std::uint64_t evaluations = simulation.evaluations(), before = simulation.step();
    simulation.advance(due);
    if (companions && simulation.step() > before) companions->go_to(simulation.step(), segments);
    const std::uint64_t taken = std::max(simulation.step(), before) - before;
    pace.took(taken, std::max(simulation.evaluations(), evaluations) - evaluations,
              static_cast<double>(taken) * simulation.dt(), begin, Clock::now(), rate);
    keep_moment();
    if (simulation.divergence()) playing = false;
}

/// Something to come back to; in a large scene that is a copy as costly as some steps.
void Worker::Body::keep_moment() {
    const auto begin = Clock::now();
    if (!moments.due(begin)) return;
    history.offer(simulation);
    moments.took(begin, Clock::now());
}

/// True if a view would cost the run no more than its part, or the run has time to spare.
bool Worker::Body::affordable() const {
    const auto now = Clock::now();
    return !playing || views.due(now) || pace.next_due(now, rate, simulation.dt()) > now;
}

/// Makes a view of the present moment, unless the last one is still waiting and has not grown stale.
void Worker::Body::publish() {
    const auto begin = Clock::now();
    {
        const std::lock_guard lock(mutex);
        if (playing && fresh && begin - published < stale) return;
    }
    look(simulation, tracked, view);
    view.playing = playing;
    view.cloud = cloud;
    view.cloud_reading = {.step = companions ? companions->step() : 0};
    if (companions && !companions_are_behind()) view.cloud_reading = companions->look(view.frame);
    view.can_step_back = history.reaches_before(simulation.step());
    view.rate = rate;
    view.run = run;
    view.error = error;
    view.steps_per_second = pace.steps_per_second();
    view.evaluations_per_second = pace.evaluations_per_second();
    void (*call)() = nullptr;
    {
        const std::lock_guard lock(mutex);
        std::swap(view, ready);
        fresh = true;
        call = wake;
    }
    published = Clock::now();
    views.took(begin, published);
    if (call) call();
}

/// The companions begin where the run began.
void Worker::Body::show_cloud(Cloud asked) {
    cloud = std::move(asked);
    companions.reset();
    if (cloud.runs == 0) return;
    companions.emplace(cloud.runs, [of = cloud](const RunDescription& description, std::size_t companion) {
        return spread_run(description, std::vector{spread_of(of, description)}, companion, of.runs);
    });
}

void Worker::Body::apply(const RunDescription& description) {
    const bool at_start = simulation.step() == 0;
    const Change change = simulation.change(description);
    if (change == Change::none) return;
    pace.forget_speed();
    if (change == Change::restarted || at_start) {
        begin_anew();
    } else {
        segments.push_back({simulation.step(), description});
        history.offer(simulation);
    }
    pace.begin(Clock::now());
}

void Worker::Body::begin_anew() {
    ++run;
    history.clear();
    history.offer(simulation);
    segments = {{0, simulation.description()}};
    show_cloud(cloud);
}

void Worker::Body::step_back() {
    playing = false;
    if (simulation.step() == 0) return;
    history.go_back(simulation, simulation.step() - 1);
    if (segments.back().step <= simulation.step()) return;
    while (segments.back().step > simulation.step()) segments.pop_back();
    show_cloud(cloud);
}

void Worker::Body::pull(std::size_t particle, Vec3 position) {
    const std::uint64_t segment = simulation.segment();
    simulation.pull(particle, position);
    if (simulation.segment() == segment) return;
    append_pull(segments, {simulation.step(), simulation.description(), SegmentBegin::Pull{particle, position}});
    history.offer(simulation);
}

void Worker::Body::play(bool on) {
    playing = on && !simulation.divergence();
    pace.begin(Clock::now());
}

Worker::Worker(const RunDescription& description) : body_(std::make_unique<Body>(description)) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
    }
    body_->changed.notify_one();
    body_->thread.join();
}

void Worker::play(bool on) {
    body_->post([on](Body& body) { body.play(on); });
}

void Worker::step_forward() {
    body_->post([](Body& body) {
        body.playing = false;
        body.simulation.advance(1);
        body.history.offer(body.simulation);
    });
}

void Worker::step_back() {
    body_->post([](Body& body) { body.step_back(); });
}

void Worker::restart() {
    body_->post([](Body& body) {
        body.simulation.restart();
        body.begin_anew();
        body.pace.begin(Clock::now());
    });
}

void Worker::change(const RunDescription& description) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->wanted = description;
    }
    body_->changed.notify_one();
}

void Worker::pull(std::size_t particle, Vec3 position) {
    body_->post([=](Body& body) { body.pull(particle, position); });
}

void Worker::show_cloud(const Cloud& cloud) {
    body_->post([cloud](Body& body) {
        body.show_cloud(cloud);
        body.pace.forget_speed();
    });
}

void Worker::set_rate(Rate rate) {
    body_->post([rate](Body& body) {
        body.rate = rate;
        body.pace.begin(Clock::now());
    });
}

void Worker::track(std::optional<std::size_t> particle) {
    body_->post([particle](Body& body) { body.tracked = particle; });
}

bool Worker::take(RunView& view) {
    const std::lock_guard lock(body_->mutex);
    if (!body_->fresh) return false;
    std::swap(view, body_->ready);
    body_->fresh = false;
    return true;
}

void Worker::on_view(void (*wake)()) {
    const std::lock_guard lock(body_->mutex);
    body_->wake = wake;
}

}  // namespace steplab
