#pragma once

#include "session/history.hpp"
#include "session/pace.hpp"
#include "session/share.hpp"
#include "session/worker.hpp"
#include "sim/ensemble/live_ensemble.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace steplab {

/// The worker's thread and what it works with.
struct Worker::Body {
    using Clock = std::chrono::steady_clock;

    /// Of the time of a run that has none to spare: for views, and for moments to come back to.
    static constexpr double part_for_views = 0.02, part_for_history = 0.01;
    /// But a picture that moves less often than this is of no use to who watches.
    static constexpr std::chrono::milliseconds longest_without_view{500};

    // shared between the threads
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void(Body&)>> commands;
    std::optional<RunDescription> wanted;  // the newest change asked for; older ones it overtook are never computed
    std::atomic<bool> stopping = false;    // also in the middle of a long step
    bool fresh = false;                    // `ready` has not been taken yet
    RunView ready;
    std::optional<Doubt> doubt;  // told while `doubtful` lasts
    void (*wake)() = nullptr;

    // the worker's own
    Simulation simulation;
    History history;
    Pace pace;
    Rate rate;
    bool playing = false;
    bool doubtful = false;       // the energy is impossible, and the check that decides about it has not come yet
    std::optional<Doubt> found;  // where `doubtful` began
    std::optional<std::uint64_t> goal;  // the step that the run is on its way to
    std::optional<std::size_t> tracked;
    bool with_forces = false;            ///< in views
    std::vector<SegmentBegin> segments;  // of the run so far
    LiveEnsembleOptions ensemble;
    std::optional<LiveEnsemble> live_ensemble;
    std::uint64_t run = 0;
    std::string error;
    std::uint64_t failures = 0;
    RunView view;
    Clock::time_point published;
    Share views{part_for_views, longest_without_view}, moments{part_for_history};
    std::thread thread;

    explicit Body(const RunDescription& description) : simulation(description), segments{{0, description}} {
        history.offer(simulation);
        see();
        std::swap(view, ready);
        fresh = true;
        thread = std::thread([this] { loop(); });
    }

    void post(std::function<void(Body&)> command) {
        {
            const std::lock_guard lock(mutex);
            commands.push_back(std::move(command));
        }
        changed.notify_one();
    }

    /// An error is reported in the next view, and the thread continues: true if there was none.
    template <class Work>
    bool went_well(const Work& work) {
        try {
            work();
            return true;
        } catch (const std::exception& problem) {
            error = problem.what();
            ++failures;
            return false;
        }
    }

    void loop();
    void wait_for_work();
    bool carry_out_commands();
    void take_steps();
    void step_to_check();
    void tell_doubt();
    bool ensemble_is_behind() const { return live_ensemble && !live_ensemble->are_at(simulation.step(), segments); }
    void bring_ensemble(Pace::Duration most);
    void keep_moment();
    bool affordable() const;
    void see();
    void publish(bool at_once, bool judged);
    void give_up();
    void tell_in(RunView& older) const;
    void show_ensemble(LiveEnsembleOptions asked);
    void step_back();
    void pull(std::size_t particle, Vec3 position);
    void apply(const RunDescription& description);
    void begin_anew();
    void play(bool on);
};

}  // namespace steplab
