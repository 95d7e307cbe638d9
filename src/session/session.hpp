#pragma once

#include "session/event.hpp"
#include "session/follower_run.hpp"
#include "session/late_samples.hpp"
#include "session/recording.hpp"
#include "session/session_view.hpp"
#include "session/spread_samples.hpp"
#include "session/time_line.hpp"
#include "sim/ensemble/live_ensemble.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace steplab {

/// What a person does with runs: one to four of one scene, which stand at the same time, and everything that was done
/// to them. It has neither a thread nor a clock of its own: it is told how many steps to take. The same events at the
/// same steps give the same session, bit for bit.
class Session {
public:
    static constexpr std::size_t most_runs = 4;
    /// Ways and runs that were left and are kept for coming back.
    static constexpr std::size_t most_branches = 16, most_left = 4;

    /// `bytes`: memory for moments to come back to. Throws UsageError.
    explicit Session(const RunDescription& description, std::size_t bytes = TimeLine::usual_bytes);

    /// Does what an event says, at the step where the leading run stands. Throws UsageError, nothing changed.
    void handle(const Event& event);

    /// Keeps from now on what happens; to be called before anything does. Every event gets a hash while the scene has
    /// no more particles than this, as a hash takes about as long as a step of a cheap method.
    void record(std::size_t most_hashed = std::numeric_limits<std::size_t>::max());
    /// For so many seconds it had stood still when the next event came: that is recorded with it.
    void stood_still(double seconds) { stood_ = seconds; }
    /// What happened so far, and where the runs are, unless that is not to be asked. Empty without record().
    std::optional<Recording> recorded(bool with_end = true) const;
    /// Takes the leading run to a step that it has been at or can get to, without regard to its goal. Throws as
    /// advance() does.
    void stand_at(std::uint64_t step);

    const Simulation& run() const { return line_.run(); }
    const TimeLine& line() const { return line_; }
    const std::vector<FollowerRun>& followers() const { return followers_; }
    bool playing() const { return playing_; }
    bool plays_backwards() const { return playing_ && backwards_; }
    Rate rate() const { return rate_; }
    /// The step that the leading run is on its way to.
    std::optional<std::uint64_t> goal() const { return goal_; }

    /// Takes steps of the leading run, and those of the others if they are beside it. Throws Interrupted.
    void advance(std::uint64_t steps);
    /// The same in the direction in which the session plays; at the end of its loop it goes to the other end. Returns
    /// how many steps it took before. Throws Interrupted.
    std::uint64_t play_on(std::uint64_t steps);
    /// True while what goes beside the leading run is not there yet, as it began later or went back.
    bool is_behind() const;
    /// Brings it nearer, until it is there or `enough` says so. Throws Interrupted; what cannot follow is given up, and
    /// the reason thrown as UsageError.
    void catch_up(const std::function<bool()>& enough);
    /// Takes the session to its goal and all runs to one time. Throws as advance() and catch_up() do.
    void finish();
    /// Pauses where the leading run stands.
    void stop();
    /// Plays on where an event that is played again has paused.
    void keep_playing() {
        playing_ = !line_.is_over();
        backwards_ = false;
    }
    /// Where memory ran out.
    void give_up_ensemble() { show_ensemble({}); }
    /// Keeps the present moment, unless one is near.
    void keep_moment() { line_.keep_moment(); }

    /// Particles up to which a run alone is compared with a reference run, if its scene has no exact solution.
    static constexpr std::size_t most_compared_alone = 300;
    /// True if the runs are to be compared with the motion of their scene: two and more of them always.
    bool wants_errors() const;
    bool wants_costs() const { return with_costs_; }
    /// True if samples are taken on the way.
    bool takes_samples() const { return with_samples_; }
    /// True if some may be lacking of where the runs were: of another particle, of before samples were taken, of a way
    /// that was taken again.
    bool lacks_samples() const { return lacking_; }
    /// Takes those, until they are there or `enough` says so, by going the same way once more; true if there were some.
    /// Throws Interrupted.
    bool complete_samples(const std::function<bool()>& enough);
    /// The present moment of all runs, reusing the memory of `view`.
    void observe(SessionView& view) const;

private:
    struct Handle;
    /// What goes beside the leading run.
    struct Beside {
        struct Run {
            RunDescription description;
            std::size_t swatch = 0;
            friend bool operator==(const Run&, const Run&) = default;
        };
        std::vector<Run> runs;
        std::size_t swatch = 0;  ///< of the leading run
        bool equal_cost = false;
        friend bool operator==(const Beside&, const Beside&) = default;
    };
    /// All that a restart, another scene or another leading run leaves behind.
    struct Left {
        TimeLine line;
        std::vector<TimeLine::Branch> branches;
        std::vector<Mark> bookmarks;
        Beside beside;
    };
    /// A change or act on the time line, which knows it.
    struct Acted {};
    /// Another way was taken; all changes of the one that was left for it, which is among the branches.
    struct Way {
        std::vector<SegmentBegin> changes;
    };
    /// What can be taken back, by what there was before; and what undoing took back.
    using Done = std::variant<Acted, Beside, Left, Way>;
    using Undone = std::variant<TimeLine::Branch, Beside, Left, Way>;

    void handle_and_record(const Event& event);
    std::string event_hash() const;
    void play(const event::Play& play);
    void loop(const event::Loop& loop);
    std::uint64_t first_played() const;
    void turn_at_end();
    void step(std::int64_t steps);
    void seek(std::uint64_t step);
    void bookmark(const std::string& text);
    TimeLineView line_view() const;
    void show_ensemble(const LiveEnsembleOptions& asked);
    TrackedParticles tracked() const { return tracked_particles(tracked_, also_tracked_); }
    void sample_spread();
    void look_for_lacking(const Event& event);
    bool ensemble_is_beside() const;
    void take_forward(std::uint64_t steps);

    // what is done to the leading run
    void begin(const RunDescription& description, bool held = false);
    void begin_alone(const RunDescription& description);
    void begun();
    void change(const event::Change& change);
    void act(const Act& asked);
    void undo();
    void redo();
    void keep(std::optional<TimeLine::Branch> left);
    void note(Done before);
    void acted(std::size_t changes_before);
    bool can_undo() const;
    bool can_undo_on_line() const;
    void count_acted(std::size_t changes_before);
    void forget_oldest_left();
    void take_branch(std::size_t number);
    std::optional<Way> go_over_to(std::size_t branch);
    std::optional<Way> go_back_to(const Way& way);
    void leave(TimeLine next, Beside beside);
    Left exchange(Left& other);
    Beside exchange(const Beside& wanted);

    // what goes beside it
    void add(const event::AddRun& added);
    void change_run(std::size_t run, const RunDescription& description);
    void set_equal_cost(bool on);
    void lead(std::size_t follower);
    void remove(std::size_t run);
    std::size_t check_follower(std::size_t run) const;
    void check_followers(std::span<const SegmentBegin> way) const;
    Beside beside() const;
    std::vector<FollowerRun> made(const Beside& wanted) const;
    FollowerRun follower(const RunDescription& description, std::size_t swatch) const;
    std::size_t free_swatch() const;
    void settle_swatch();
    RunDescription at_cost(const RunDescription& description) const;
    void equalise_cost();

    std::size_t bytes_;
    TimeLine line_;           ///< of the leading run
    std::size_t swatch_ = 0;  ///< the same
    std::vector<FollowerRun> followers_;
    std::vector<TimeLine::Branch> branches_;
    std::vector<Done> done_;  ///< the last one can be taken back first
    std::vector<Undone> undone_;
    std::vector<Mark> bookmarks_;
    bool playing_ = false;
    bool backwards_ = false;         ///< the way it plays
    std::optional<StepRange> loop_;  ///< in which it plays
    Rate rate_;
    std::optional<std::uint64_t> goal_;
    std::optional<std::size_t> tracked_;
    std::vector<std::size_t> also_tracked_;
    bool with_forces_ = false, with_samples_ = false, with_costs_ = false;
    LateSamples late_;
    bool lacking_ = false;  ///< samples may be
    double magnified_ = 1;
    bool equal_cost_ = false;
    std::string not_equal_;            ///< why a run does not have the cost of the leading one; empty: all have
    std::optional<bool> with_errors_;  ///< none: as usual
    LiveEnsembleOptions ensemble_;
    mutable std::optional<LiveEnsemble> live_ensemble_;
    std::optional<SpreadSamples> spread_;  ///< of it, if samples are taken
    std::uint64_t number_ = 0;             ///< of the run: grows when one begins again
    std::optional<Recording> recording_;
    std::size_t most_hashed_ = 0;
    double stood_ = 0;
    std::uint64_t known_ = 0;  ///< reached when the last event was recorded
};

}  // namespace steplab
