#pragma once

#include "core/diagnostics.hpp"
#include "core/frame.hpp"
#include "models/conservation.hpp"
#include "sim/run/act.hpp"
#include "sim/run/exact_motion.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/method_refusals.hpp"
#include "sim/run/resolution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace steplab {

/// How a run ended that could not continue.
struct Divergence {
    std::uint64_t step = 0;    ///< the last good step; the run stands there
    double time = 0;           ///< its time
    std::size_t particle = 0;  ///< the particle that left first (largest speed, or not finite) in the step after
    double dt = 0;
    std::optional<double> limit;  ///< the method's stability limit for this scene, where known; 0 = unstable at any dt
    std::optional<OwnStop> stop;  ///< if no step of the method met its tolerance; its time that of the run
    std::string message;          ///< one sentence: what happened, why
};

/// What a change of description did to the run.
enum class Change { none, continued, restarted };

/// True if a run of the first description begins again with the second: another scene, or a parameter that shapes it.
bool restarts(const RunDescription& from, const RunDescription& to);

/// One run under way: owns the scene, the method's internal state and the clock in steps.
class Simulation {
public:
    /// Throws UsageError if the description cannot be run (see check()).
    explicit Simulation(const RunDescription& description, const Execution& execution = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    const RunDescription& description() const;
    std::uint64_t step() const;
    /// t0 + (step - step0) dt of the segment, in double, with dt as the precision holds it.
    double time() const;
    double dt() const;
    std::size_t particles() const;
    /// Of the whole run, over all segments.
    std::uint64_t evaluations() const;
    /// Collisions of the present segment where a force jumps, as adaptive methods find them; times since its start.
    CollisionRecord collisions() const;

    /// Before the first step: where the last step ends before dt (run_end()). The run may go no further.
    void end_at(const RunEnd& end);
    /// Counts the work of drag from here on, which energy errors then contain; methods of kicks, and those of stages
    /// that each start from one slope, then evaluate the forces twice. False unless integrates_drag_work().
    bool count_drag_work();
    /// In J since the baseline; none if it is not counted.
    std::optional<double> drag_work() const;

    /// Takes up to `steps` steps. If the run diverges, it goes back to the last good step, which may lie before where
    /// this call began, and no further. Numbers that are not finite are found before anybody sees them, an impossible
    /// energy on a fixed grid of steps (check_interval), so that it makes no difference in how many calls the steps are
    /// taken. Throws Interrupted soon after a signal (check_interruption()); the run is lost then.
    void advance(std::uint64_t steps);
    /// Judges the energy of the present step too, as at the end of a run.
    void conclude();
    /// Steps from one check of the energy to the next, counted from the start of the segment.
    std::uint64_t check_interval() const;
    /// Steps from here to the next of them.
    std::uint64_t steps_to_check() const;
    /// False if the energy of the present step is impossible. Whether the run diverged is decided at the next check
    /// all the same.
    bool is_plausible() const;
    const std::optional<Divergence>& divergence() const;
    /// Where advance() has got to, without checking all particles: the other functions check them, and may find that
    /// the run diverged before.
    struct Advanced {
        std::uint64_t step, evaluations;
        bool diverged;
    };
    Advanced advanced() const;
    /// stability_limit() of the present description, and how its steps treat the fastest oscillation: computed once.
    const std::optional<StabilityLimit>& limit() const;
    const std::optional<Resolution>& resolution() const;
    /// What the scene as it is now lets a method keep.
    Conservation conservation() const;
    /// Why other methods cannot run the scene; never null.
    std::shared_ptr<const MethodRefusals> refusals() const;

    /// The moment as seen from outside; the run is not changed. The second form reuses the vectors of `out`; those that
    /// are not wanted are left empty.
    Frame frame() const;
    void frame(Frame& out, const FrameParts& wanted = {}) const;
    Diagnostics diagnostics() const;
    /// Both, in one pass over the run's memory.
    Diagnostics observe(Frame& out) const;
    /// Those two of them that cost least.
    double energy() const;
    double energy_error() const;
    /// Diagnostics::farthest, in little memory.
    double farthest() const;
    /// In 1/s, how fast the motion changes now, for scenes of which no frequency is known: speeds over displacements,
    /// each a root mean square of the particles that move; unless that is `enough`, also the root of accelerations over
    /// displacements, of those that are pulled. 0: nothing has moved yet.
    double rate_of_motion(double enough) const;
    /// Displacements from the reference positions and velocities of the moment, with all the digits the run has.
    const State<double>& state() const;
    /// Of a particle from its place in shape()->rest [m], with all the digits the run has.
    Vec3 displacement(std::size_t particle) const;
    /// The unchanging part of the scene; built when first asked for.
    std::shared_ptr<const Shape> shape() const;
    /// The forces in N on all particles at this moment, drag and damping included.
    void forces(std::vector<Vec3>& out) const;
    /// What gains of energy are judged by [J]: kinetic and absolute potential energy where the energy error counts
    /// from, and the scene's floor (docs/divergence.md).
    double energy_scale() const;
    /// Hash of step and synchronised state bits, 16 hexadecimal digits.
    std::string hash() const;

    /// Position of a particle at time t in closed form. None if no exact solution is known (for so long), or since the
    /// run left its conditions (a parameter of the scene was changed under way).
    std::optional<Vec3> exact_position(std::size_t particle, double time) const;
    bool has_exact() const;
    /// The same of a particle at any time; none where exact_position() has none at any.
    std::optional<ExactMotion> exact_motion(std::size_t particle) const;
    /// Why exact_position() is not known at the present step; empty if it is.
    std::string why_not_exact() const;

    /// Continues from the synchronised state with another method, dt, precision or live parameter, beginning a new
    /// segment; restarts if a parameter that shapes the scene, or the model, changes. Throws UsageError, run unchanged.
    Change change(const RunDescription& description);
    /// Does this to its particles and continues in a new segment, with a new baseline of energy if it does work.
    /// Nothing where it moves no particle (acts()).
    void act(const Act& act);
    /// From the start again.
    void restart();
    /// From the start of another description. Throws UsageError, run unchanged.
    void begin(const RunDescription& description);
    /// True since the start if nothing has changed the energy from outside; false once a live change began a new
    /// baseline.
    bool baseline_is_start() const;
    std::uint64_t baseline_step() const;

    /// Counts the stretches in which nothing was changed; after a return to an earlier one, those that begin get
    /// numbers that none had before.
    std::uint64_t segment() const;
    double segment_start() const;  ///< time at which the present one began

    /// A saved state: everything needed to return to this moment and continue with the same bits, also from another
    /// segment.
    class Snapshot {
    public:
        std::uint64_t step() const;
        std::uint64_t segment() const;
        std::size_t bytes() const;

    private:
        friend class Simulation;
        struct Content;
        std::shared_ptr<const Content> content_;
    };
    Snapshot save() const;
    void restore(const Snapshot& snapshot);

private:
    struct Body;
    void fill(Frame& out, const Portion& portion) const;
    void prepare(Frame& out, const FrameParts& wanted) const;
    Diagnostics measured(const PortionSink& also) const;
    /// The run after its numbers were checked: if they are not finite, it stands at the last good step.
    Body& settled() const;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
