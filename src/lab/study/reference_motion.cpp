#include "lab/study/reference_motion.hpp"

#include "lab/study/distances.hpp"
#include "methods/engines/extrapolation.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/act.hpp"
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

/// Between two changes.
struct Stretch {
    double begin;  ///< time
    RunDescription held;
    Plan scene;
    std::optional<Act> act;                  ///< with which it begins
    State<Real> fine_start, coarse_start;    ///< behind that
    std::unique_ptr<DenseRun> fine, coarse;  ///< once asked for
    double reached = 0;                      ///< the largest time they were asked for since their start
    State<Real> fine_state = {}, coarse_state = {};

    void go_to(double time) {
        if (!fine || time < reached) {
            fine = dense_run(scene, fine_start, fine_tolerance);
            coarse = dense_run(scene, coarse_start, coarse_tolerance);
        }
        reached = time;
        fine->at(static_cast<Real>(time) - static_cast<Real>(begin), fine_state);
        coarse->at(static_cast<Real>(time) - static_cast<Real>(begin), coarse_state);
    }
    bool stopped() const { return fine->stopped() || coarse->stopped(); }
    /// Gives memory back that is made again when a time in it is asked for.
    void rest() {
        fine.reset();
        coarse.reset();
        fine_state = coarse_state = {};
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
    std::shared_ptr<const ExactSolution> exact;  ///< of the first
    bool said_exact = false;

    explicit Body(const RunDescription& description) {
        RunDescription held = in_double(description);
        Plan scene = plan_of(held);
        exact = exact_of(held);
        said_exact = exact != nullptr;
        const State<Real> start = scene.start.state<Real>();
        stretches.push_back({0, std::move(held), std::move(scene), std::nullopt, start, start, nullptr, nullptr});
    }

    /// That in which a time lies.
    std::size_t stretch_at(double time) const {
        std::size_t last = 0;
        while (last + 1 < stretches.size() && stretches[last + 1].begin <= time) ++last;
        return last;
    }

    void append(double time, const RunDescription& held, const std::optional<Act>& act) {
        Stretch& before = stretches.back();
        before.go_to(time);
        const bool same = same_scene(held, before.held);
        Stretch next{time,    held,   same ? before.scene : plan_of(held), act, before.fine_state, before.coarse_state,
                     nullptr, nullptr};
        if (!same) {
            carry_over(before.scene, next.scene, next.fine_start);
            carry_over(before.scene, next.scene, next.coarse_start);
        }
        if (act) {
            apply(*act, next.scene.reference, next.fine_start);
            apply(*act, next.scene.reference, next.coarse_start);
        }
        before.rest();
        stretches.push_back(std::move(next));
    }

    ReferenceMoment by_runs(Stretch& stretch, double time) {
        stretch.go_to(time);
        const State<Real>& state = stretch.fine_state;
        ReferenceMoment moment{
            time, {converted<double>(state.displacement), converted<double>(state.velocity)}, infinity};
        if (!stretch.stopped())
            moment.error = largest_distance(state, stretch.coarse_state) + rounding_of(moment.state.displacement);
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
        // what is done to particles leaves the description as it was
        const RunDescription held = change.act && number > 0 ? known[number - 1].held : in_double(change.description);
        if (!first && !change.act && same_scene(held, known[number - 1].held)) continue;
        const bool same = number < known.size() && known[number].begin == change.time &&
                          known[number].act == change.act && same_scene(held, known[number].held);
        if (first && !same) {
            body_ = std::make_unique<Body>(change.description);
            return follow(changes);
        }
        if (!same) {
            known.erase(known.begin() + static_cast<std::ptrdiff_t>(number), known.end());
            body_->append(change.time, held, change.act);
        }
        ++number;
    }
    known.erase(known.begin() + static_cast<std::ptrdiff_t>(number), known.end());
}

ReferenceMoment ReferenceMotion::at(double time) {
    const std::size_t number = body_->stretch_at(time);
    Stretch& stretch = body_->stretches[number];
    body_->said_exact = number == 0 && body_->exact && time <= body_->exact->valid_until();
    if (body_->said_exact) return exact_moment(*body_->exact, stretch.scene.reference.count, time);
    return body_->by_runs(stretch, time);
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
