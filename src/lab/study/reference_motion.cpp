#include "lab/study/reference_motion.hpp"

#include "lab/study/distances.hpp"
#include "methods/engines/extrapolation.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/act.hpp"
#include "sim/run/motion_from_start.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace steplab {

namespace {

using Real = long double;

/// Of a step, relative to 1 + |value|: the finest whose estimate is not rounding of long double, and one that is far
/// enough from it to tell its error.
constexpr double fine_tolerance = 1e-17, coarse_tolerance = 1e-15;

/// States kept at the starts of stretches: of scenes of any size, and as many more as this memory holds.
constexpr std::size_t least_kept_starts = 8, most_bytes_of_starts = 32 << 20;

/// A run that can be asked for any time from the start of its last step on.
class DenseRun {
public:
    virtual ~DenseRun() = default;
    /// Takes steps until one ends at this time since its start or after it, and gives the state there.
    virtual void at(Real time, State<Real>& out) = 0;
    virtual bool stopped() const = 0;
};

template <class Force>
class DenseRunOn final : public DenseRun {
public:
    DenseRunOn(Force force, const Plan& scene, const State<Real>& start, double tolerance)
        : system_(std::move(force), static_cast<Real>(scene.drag), Real(1)), steps_(tolerance_of(tolerance)) {
        steps_.start(system_, start);
    }

    void at(Real time, State<Real>& out) override {
        steps_.take_steps_to(system_, time);
        steps_.state_at(system_, time, out);
    }
    bool stopped() const override { return steps_.stopped().has_value(); }

private:
    static ParameterValues tolerance_of(double tolerance) {
        ParameterValues values(std::span(&tolerance_parameter, 1));
        values.set(tolerance_parameter.name, tolerance);
        return values;
    }

    System<Real, Force> system_;
    AdaptiveSteps<Real, ExtrapolationRule<Real>> steps_;
};

std::unique_ptr<DenseRun> dense_run(const Plan& scene, const State<Real>& start, double tolerance) {
    return std::visit(
        [&](const auto& forces) -> std::unique_ptr<DenseRun> {
            using Force = decltype(engine<Real>(forces));
            return std::make_unique<DenseRunOn<Force>>(engine<Real>(forces), scene, start, tolerance);
        },
        scene.forces);
}

/// A scene as it is computed.
struct Held {
    RunDescription description;
    Plan plan;
};

/// The states of both runs.
struct BothStates {
    State<Real> fine, coarse;

    std::size_t bytes() const {
        return 2 * sizeof(Real) * 3 * (fine.displacement.count() + coarse.displacement.count());
    }
};

/// Between two changes.
struct Stretch {
    double begin;  ///< time
    std::shared_ptr<const Held> scene;
    std::optional<Act> act = {};                             ///< with which it begins
    std::shared_ptr<const MotionFromStart> from_start = {};  ///< if it begins at time 0
    std::optional<BothStates> start = {};                    ///< behind that; none: computed again from one before
    std::unique_ptr<DenseRun> fine = {}, coarse = {};        ///< once asked for
    double reached = 0;                                      ///< the largest time they were asked for since their start
    BothStates state = {};

    bool can_go_on_to(double time) const { return fine && time >= reached; }
    void begin_at(const BothStates& beginning) {
        fine = dense_run(scene->plan, beginning.fine, fine_tolerance);
        coarse = dense_run(scene->plan, beginning.coarse, coarse_tolerance);
    }
    void go_on_to(double time) {
        reached = time;
        fine->at(static_cast<Real>(time) - static_cast<Real>(begin), state.fine);
        coarse->at(static_cast<Real>(time) - static_cast<Real>(begin), state.coarse);
    }
    bool stopped() const { return fine->stopped() || coarse->stopped(); }
    /// Gives memory back that is made again when a time in it is asked for.
    void rest() {
        fine.reset();
        coarse.reset();
        state = {};
    }
};

/// True if one motion is that of both: what is done to the scene left aside.
bool same_scene(const RunDescription& a, const RunDescription& b) {
    return a.model == b.model && a.origin == b.origin && a.scene == b.scene && a.start == b.start &&
           a.alterations == b.alterations;
}

RunDescription in_double(RunDescription description) {
    description.precision = Precision::double_;
    return as_held(std::move(description));
}

}  // namespace

struct ReferenceMotion::Body {
    std::vector<Stretch> stretches;
    bool said_exact = false;

    explicit Body(const RunDescription& description) {
        const auto scene = held(in_double(description));
        const State<Real> start = scene->plan.start.state<Real>();
        stretches.push_back({.begin = 0,
                             .scene = scene,
                             .from_start = std::make_shared<const MotionFromStart>(scene->description),
                             .start = BothStates{start, start}});
        said_exact = exact_in(0) != nullptr;
    }

    static std::shared_ptr<const Held> held(RunDescription description) {
        Plan plan = plan_of(description);
        return std::make_shared<const Held>(Held{std::move(description), std::move(plan)});
    }

    /// The scene from the change of this number on; one that is known by content is the same object.
    std::shared_ptr<const Held> scene_from(std::size_t number, const SegmentBegin& change) const {
        // what is done to particles leaves the description as it was
        if (change.act && number > 0) return stretches[number - 1].scene;
        RunDescription description = in_double(change.description);
        for (std::size_t known = number > 0 ? number - 1 : 0; known < std::min(number + 1, stretches.size()); ++known) {
            const auto& scene = stretches[known].scene;
            if (same_scene(description, scene->description)) return scene;
        }
        return held(std::move(description));
    }

    /// What is known in closed form of a stretch.
    const ExactSolution* exact_in(std::size_t number) const {
        const auto& known = stretches[number].from_start;
        return known ? known->solution().get() : nullptr;
    }

    /// What the motion is from time 0 on with this done there, too.
    std::shared_ptr<const MotionFromStart> altered_at_start(std::shared_ptr<const MotionFromStart> known,
                                                            const Held& scene, const std::optional<Act>& act) const {
        if (known && &scene != stretches.back().scene.get()) known = known->in(scene.description);
        return known && act ? known->after(*act) : known;
    }

    /// That in which a time lies.
    std::size_t stretch_at(double time) const {
        std::size_t last = 0;
        while (last + 1 < stretches.size() && stretches[last + 1].begin <= time) ++last;
        return last;
    }

    void append(double time, std::shared_ptr<const Held> scene, const std::optional<Act>& act) {
        go_to(stretches.size() - 1, time);
        auto known = time == 0 ? altered_at_start(stretches.back().from_start, *scene, act) : nullptr;
        stretches.push_back({.begin = time, .scene = std::move(scene), .act = act, .from_start = std::move(known)});
        stretches.back().start = start_behind(stretches.size() - 2);
        keep_fewer_starts();
    }

    void go_to(std::size_t number, double time) {
        Stretch& stretch = stretches[number];
        if (!stretch.can_go_on_to(time)) stretch.begin_at(start_of(number));
        stretch.go_on_to(time);
    }

    BothStates start_of(std::size_t number) {
        std::size_t known = number;
        while (!stretches[known].start) --known;
        BothStates start = *stretches[known].start;
        for (; known < number; ++known) {
            stretches[known].begin_at(start);
            stretches[known].go_on_to(stretches[known + 1].begin);
            start = start_behind(known);
        }
        return start;
    }

    /// Of the stretch behind this one, which is at its end and is left.
    BothStates start_behind(std::size_t number) {
        Stretch& before = stretches[number];
        const Stretch& next = stretches[number + 1];
        BothStates start = before.state;
        for (State<Real>* const state : {&start.fine, &start.coarse}) {
            if (next.scene != before.scene) carry_over(before.scene->plan, next.scene->plan, *state);
            if (next.act) apply(*next.act, next.scene->plan.reference, *state);
        }
        before.rest();
        return start;
    }

    /// A pull that is held gives an impulse for each picture.
    void keep_fewer_starts() {
        const auto kept = static_cast<std::size_t>(std::count_if(
            stretches.begin(), stretches.end(), [](const Stretch& one) { return one.start.has_value(); }));
        if (kept <= least_kept_starts || kept * stretches.front().start->bytes() <= most_bytes_of_starts) return;
        bool keep = false;  // every other one between the first and the last
        for (auto stretch = stretches.begin() + 1; stretch + 1 < stretches.end(); ++stretch) {
            if (!stretch->start) continue;
            if (!keep) stretch->start.reset();
            keep = !keep;
        }
    }

    ReferenceMoment by_runs(std::size_t number, double time) {
        go_to(number, time);
        const auto& [fine, coarse] = stretches[number].state;
        ReferenceMoment moment{
            time, {converted<double>(fine.displacement), converted<double>(fine.velocity)}, infinity};
        if (!stretches[number].stopped())
            moment.error = largest_distance(fine, coarse) + rounding_of(moment.state.displacement);
        return moment;
    }
};

ReferenceMotion::ReferenceMotion(const RunDescription& description) : body_(std::make_unique<Body>(description)) {}
ReferenceMotion::~ReferenceMotion() = default;
ReferenceMotion::ReferenceMotion(ReferenceMotion&&) noexcept = default;
ReferenceMotion& ReferenceMotion::operator=(ReferenceMotion&&) noexcept = default;

void ReferenceMotion::follow(std::span<const SegmentBegin> changes) {
    std::vector<Stretch>& known = body_->stretches;
    std::size_t number = 0;  // of stretches that are those of the changes so far
    for (const SegmentBegin& change : changes) {
        const bool first = &change == &changes.front();
        auto scene = body_->scene_from(number, change);
        if (!first && !change.act && scene == known[number - 1].scene) continue;
        const bool same = number < known.size() && known[number].begin == change.time &&
                          known[number].act == change.act && known[number].scene == scene;
        if (first && !same) {
            body_ = std::make_unique<Body>(change.description);
            return follow(changes);
        }
        if (!same) {
            known.erase(known.begin() + static_cast<std::ptrdiff_t>(number), known.end());
            body_->append(change.time, std::move(scene), change.act);
        }
        ++number;
    }
    known.erase(known.begin() + static_cast<std::ptrdiff_t>(number), known.end());
}

ReferenceMoment ReferenceMotion::at(double time) {
    const std::size_t number = body_->stretch_at(time);
    const ExactSolution* const exact = body_->exact_in(number);
    body_->said_exact = exact && time <= exact->valid_until();
    if (!body_->said_exact) return body_->by_runs(number, time);
    return exact_moment(*exact, body_->stretches[number].scene->plan.reference.count, time);
}

bool ReferenceMotion::is_exact() const { return body_->said_exact; }

std::string ReferenceMotion::how() const {
    if (body_->said_exact) return "exact solution";
    return fmt::format(
        "extrapolation of order {} in long double with tolerance {:.0e}; error estimated by a run with tolerance "
        "{:.0e}",
        Extrapolation<Real>::order, fine_tolerance, coarse_tolerance);
}

}  // namespace steplab
