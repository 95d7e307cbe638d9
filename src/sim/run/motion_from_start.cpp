#include "sim/run/motion_from_start.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/known_motion.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

bool same(const Field<double>& a, const Field<double>& b) {
    return std::equal(a.flat().begin(), a.flat().end(), b.flat().begin(), b.flat().end());
}

bool same(const State<double>& a, const State<double>& b) {
    return same(a.displacement, b.displacement) && same(a.velocity, b.velocity);
}

}  // namespace

MotionFromStart::MotionFromStart(RunDescription held) : held_(std::move(held)) {}

MotionFromStart::MotionFromStart(RunDescription held, State<double> start)
    : held_(std::move(held)), start_(std::move(start)) {}

std::shared_ptr<const MotionFromStart> MotionFromStart::after(const Act& act) const {
    const Plan plan = plan_of(held_);
    if (plan.reference.count > most_particles) return nullptr;
    State<double> start = start_ ? *start_ : plan.start.state();
    apply(act, plan.reference, start);
    return std::shared_ptr<const MotionFromStart>(new MotionFromStart(held_, std::move(start)));
}

std::shared_ptr<const MotionFromStart> MotionFromStart::in(RunDescription held) const {
    const Plan from = plan_of(held_), to = plan_of(held);
    State<double> start = start_ ? *start_ : from.start.state();
    carry_over(from, to, start);
    if (!start_ && same(start, to.start.state())) return std::make_shared<const MotionFromStart>(std::move(held));
    if (to.reference.count > most_particles) return nullptr;
    return std::shared_ptr<const MotionFromStart>(new MotionFromStart(std::move(held), std::move(start)));
}

/// A run backward in time has none.
std::shared_ptr<const ExactSolution> MotionFromStart::solution() const {
    std::call_once(found_, [this] {
        if (!start_) {
            solution_ = exact_of(held_);
        } else if (held_.dt > 0) {
            Plan plan = plan_of(held_);
            plan.start = Start(*start_);
            solution_ = known_motion(plan);
        }
    });
    return solution_;
}

}  // namespace steplab
