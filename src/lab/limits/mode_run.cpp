#include "lab/limits/mode_run.hpp"

#include "core/flush_subnormals.hpp"
#include "core/interruption.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/ensemble/lane_compatible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// Largest number of steps between two measurements of the vibration.
constexpr std::uint64_t longest_block = 32;
/// An unstable departure may grow by e^3 between two measurements.
constexpr double departed = 3;
/// Logarithm of the amplitude ratio that counts as unstable: a factor of 100. (Just below a limit a bounded vibration
/// grows too, by (8 (1 - dt / limit))^(-1/2): by a factor of 100 only within 2e-5 of the limit.)
constexpr double grown = 4.6;

double dot(const Field<double>& a, const Field<double>& b) {
    return std::inner_product(a.flat().begin(), a.flat().end(), b.flat().begin(), 0.0);
}

/// a(x), computed by the engine of the layout.
Field<double> accelerations(const Forces& forces, const Field<double>& x) {
    Field<double> a(x.count());
    std::visit([&](const auto& layout) { engine<double>(layout).accelerations(x, a); }, forces);
    return a;
}

struct Balancer {
    const Field<double>& start;

    void operator()(ConstantForces& forces) const { forces.step = 0; }
    void operator()(LineForces& forces) const { forces.gravity = 0; }
    void operator()(GridForces&) const {}  // starts in equilibrium
    void operator()(PairForces& forces) const { balance(forces); }
    void operator()(NearPairForces& forces) const { balance(forces); }
    void operator()(ComposedForces& forces) const {
        Composition balanced = *forces.terms;
        const Field<double> a = accelerations(forces, start);
        if (balanced.accelerations.size() < forces.count)
            balanced.accelerations.assign(forces.count,
                                          balanced.accelerations.empty() ? Vec3{} : balanced.accelerations.front());
        for (std::size_t i = 0; i < forces.count; ++i) balanced.accelerations[i] = balanced.accelerations[i] - a.at(i);
        forces.terms = std::make_shared<const Composition>(std::move(balanced));
    }

    template <class Pair>
    void balance(Pair& forces) const {
        forces.balance = std::make_shared<const Field<double>>(accelerations(forces, start));
    }
};

}  // namespace

Plan balanced(Plan scene) {
    const Field<double> start = scene.start.state().displacement;
    std::visit(Balancer{start}, scene.forces);
    return scene;
}

/// Displacement and velocity along the mode, in units of its shape.
struct ModeRun::Motion {
    double x = 0, v = 0;

    double size(double rate) const { return std::hypot(x, v / rate); }
};

/// The course of a vibration in one run. Sizes are logarithms.
class ModeRun::Course {
public:
    Course(const GrowthQuestion& question, double rate) : question_(question), rate_(rate), motion_{1, rate} {}

    bool open() const { return step_ < question_.steps && size_ < grown; }
    bool grew() const { return !(size_ < infinity) || size_ >= grown || late_ > early_ + question_.allowed; }
    double dt() const { return question_.dt; }

    /// The motion scaled back to its initial size, from which the next block starts.
    Motion shrunk() const {
        const double before = motion_.size(rate_);
        return {motion_.x / before, motion_.v / before};
    }
    /// Adds the motion after one more step, in units of that at the start of the block.
    void measure(const Motion& motion) {
        motion_ = motion;
        factor_ = std::log(motion.size(rate_));
        ++step_;
        const std::uint64_t eighth = question_.steps / 8;
        if (step_ > eighth && step_ <= 3 * eighth) early_ = std::max(early_, size_ + factor_);
        if (step_ > 6 * eighth) late_ = std::max(late_, size_ + factor_);
    }
    void end_block() { size_ += factor_; }

private:
    GrowthQuestion question_;
    double rate_;
    Motion motion_;
    double factor_ = 0, size_ = 0, early_ = -infinity, late_ = -infinity;
    std::uint64_t step_ = 0;
};

ModeRun::ModeRun(const Method& method, const ParameterValues& parameters, Precision precision, const Plan& scene,
                 const Field<double>& shape, double omega, double size, double departure)
    : method_(method),
      parameters_(parameters),
      precision_(precision),
      scene_(scene),
      start_(scene.start.state().displacement),
      shape_(shape),
      omega_(omega),
      rate_(std::max(omega, scene.drag)),
      departure_(departure) {
    double largest = 0;
    for (const double number : shape.flat()) largest = std::max(largest, std::abs(number));
    for (double& number : shape_.flat()) number *= size / largest;
    weighted_ = shape_;
    for (std::size_t i = 0; i < scene.masses.size(); ++i) weighted_.set(i, scene.masses[i] * shape_.at(i));
    norm_ = dot(weighted_, shape_);
}

std::uint64_t ModeRun::block(double dt) const {
    return static_cast<std::uint64_t>(
        std::clamp(departed / (departure_ * dt), 1.0, static_cast<double>(longest_block)));
}

State<double> ModeRun::state(const Motion& motion) const {
    State<double> state{start_, Field<double>(start_.count())};
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) {
        state.displacement.flat()[k] += motion.x * shape_.flat()[k];
        state.velocity.flat()[k] = motion.v * shape_.flat()[k];
    }
    return state;
}

StepperSetup ModeRun::setup(State<double> start, double dt) const {
    return {scene_, std::move(start), parameters_, precision_, dt};
}

/// Runs one block.
void ModeRun::take(Course& course) const {
    State<double> state = this->state(course.shrunk());
    const auto stepper = method_.make(setup(state, course.dt()));
    for (std::uint64_t steps = block(course.dt()); steps > 0; --steps) {
        stepper->advance(1);
        stepper->synchronised(state);
        for (std::size_t k = 0; k < shape_.flat().size(); ++k) state.displacement.flat()[k] -= start_.flat()[k];
        course.measure({dot(weighted_, state.displacement) / norm_, dot(weighted_, state.velocity) / norm_});
    }
    course.end_block();
}

/// Runs one block of those that are open, whose blocks have the same length.
void ModeRun::take(std::span<Course> courses, EnsembleStepper& group) const {
    std::vector<State<double>> starts;
    std::vector<std::size_t> open;
    for (std::size_t run = 0; run < courses.size(); ++run) {
        starts.push_back(state(courses[run].shrunk()));
        if (courses[run].open()) open.push_back(run);
    }
    group.restart(starts);
    std::array<Along, most_lanes> along;
    for (std::uint64_t steps = block(courses.front().dt()); steps > 0; --steps) {
        group.advance(1);
        group.along(weighted_, start_, along);
        for (const std::size_t run : open)
            courses[run].measure({along[run].displacement / norm_, along[run].velocity / norm_});
    }
    for (const std::size_t run : open) courses[run].end_block();
}

bool ModeRun::grows(const GrowthQuestion& question) const {
    const FlushSubnormals flush;
    Course course(question, rate_);
    while (course.open()) {
        check_interruption();
        take(course);
    }
    return course.grew();
}

std::unique_ptr<EnsembleStepper> ModeRun::group(std::span<const GrowthQuestion> questions) const {
    std::vector<StepperSetup> setups;
    for (const GrowthQuestion& question : questions) setups.push_back(setup(state({1, rate_}), question.dt));
    if (!method_.runs_in_lanes(setups.front().instructions) || !fits_lanes(setups.front())) return nullptr;
    for (const StepperSetup& other : setups) {
        if (!lane_compatible(setups.front(), other)) return nullptr;
    }
    return method_.make_ensemble_stepper(setups);
}

std::size_t ModeRun::most_at_once() const {
    const auto widest = group(std::vector<GrowthQuestion>(most_lanes, {.dt = time_scale()}));
    return widest ? widest->runs() : 1;
}

void ModeRun::answer(std::span<GrowthQuestion> questions) const {
    const FlushSubnormals flush;
    const auto other = std::find_if(questions.begin(), questions.end(), [&](const GrowthQuestion& question) {
        return block(question.dt) != block(questions.front().dt);
    });
    questions = questions.first(static_cast<std::size_t>(other - questions.begin()));
    const auto group = this->group(questions);
    if (!group) {
        questions.front().grows = grows(questions.front());
        return;
    }
    std::vector<Course> courses;
    for (std::size_t run = 0; run < group->runs(); ++run) courses.emplace_back(questions[run], rate_);
    while (std::any_of(courses.begin(), courses.end(), [](const Course& course) { return course.open(); })) {
        check_interruption();
        take(courses, *group);
    }
    for (std::size_t run = 0; run < courses.size(); ++run) questions[run].grows = courses[run].grew();
}

double ModeRun::nonlinearity() const {
    Field<double> x = start_;
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) x.flat()[k] += shape_.flat()[k];
    const Field<double> there = accelerations(scene_.forces, x);
    const Field<double> here = accelerations(scene_.forces, start_);
    double difference = 0;
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) {
        const double rest = there.flat()[k] - here.flat()[k] + omega_ * omega_ * shape_.flat()[k];
        const double relative = rest / (rate_ * rate_);  // of a size that has a square, however stiff the springs are
        difference += relative * relative;
    }
    return std::sqrt(difference / norm_);
}

}  // namespace steplab
