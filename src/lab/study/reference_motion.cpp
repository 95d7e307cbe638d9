#include "lab/study/reference_motion.hpp"

#include "lab/study/distances.hpp"
#include "methods/engines/extrapolation.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

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
    /// Takes steps until one ends at this time or after it, and gives the state there.
    virtual void at(double time, State<Real>& out) = 0;
    virtual bool stopped() const = 0;
};

template <class Force>
class DenseRunOn final : public DenseRun {
public:
    DenseRunOn(Force force, const Plan& scene, double tolerance)
        : system_(std::move(force), static_cast<Real>(scene.drag), Real(1)), steps_(tolerance_of(tolerance)) {
        steps_.start(system_, scene.start.state<Real>());
    }

    void at(double time, State<Real>& out) override {
        steps_.take_steps_to(system_, static_cast<Real>(time));
        steps_.state_at(system_, static_cast<Real>(time), out);
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

std::unique_ptr<DenseRun> dense_run(const Plan& scene, double tolerance) {
    return std::visit(
        [&](const auto& forces) -> std::unique_ptr<DenseRun> {
            using Force = decltype(engine<Real>(forces));
            return std::make_unique<DenseRunOn<Force>>(engine<Real>(forces), scene, tolerance);
        },
        scene.forces);
}

}  // namespace

struct ReferenceMotion::Body {
    RunDescription held;
    Plan scene;
    std::shared_ptr<const ExactSolution> exact;
    std::unique_ptr<DenseRun> fine, coarse;  ///< once a time is asked for that has no closed form
    double reached = 0;                      ///< the largest time they were asked for since their start
    State<Real> fine_state, coarse_state;
    bool said_exact = false;

    explicit Body(const RunDescription& description)
        : held(as_held(description)), scene(plan_of(held)), exact(exact_of(held)), said_exact(exact != nullptr) {}

    void begin() {
        fine = dense_run(scene, fine_tolerance);
        coarse = dense_run(scene, coarse_tolerance);
        reached = 0;
    }

    ReferenceMoment by_runs(double time) {
        if (!fine || time < reached) begin();
        reached = time;
        fine->at(time, fine_state);
        coarse->at(time, coarse_state);
        ReferenceMoment moment{
            time, {converted<double>(fine_state.displacement), converted<double>(fine_state.velocity)}, infinity};
        if (fine->stopped() || coarse->stopped()) return moment;
        moment.error = largest_distance(fine_state, coarse_state) + rounding_of(moment.state.displacement);
        return moment;
    }
};

ReferenceMotion::ReferenceMotion(const RunDescription& description) : body_(std::make_unique<Body>(description)) {}
ReferenceMotion::~ReferenceMotion() = default;
ReferenceMotion::ReferenceMotion(ReferenceMotion&&) noexcept = default;
ReferenceMotion& ReferenceMotion::operator=(ReferenceMotion&&) noexcept = default;

ReferenceMoment ReferenceMotion::at(double time) {
    body_->said_exact = body_->exact && time <= body_->exact->valid_until();
    if (body_->said_exact) return exact_moment(*body_->exact, body_->scene.reference.count, time);
    return body_->by_runs(time);
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
