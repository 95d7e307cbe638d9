#include "lab/mode_run.hpp"

#include "core/flush_subnormals.hpp"
#include "io/interruption.hpp"
#include "sim/stepper_of.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace steplab {

namespace {

/// Steps between two looks at the vibration, at most.
constexpr std::uint64_t longest_block = 32;
/// What departs by itself may grow by e^3 between two looks.
constexpr double departed = 3;
/// Logarithms of sizes: a hundredfold is unstable. (Just below a limit a bounded vibration swells too, by
/// (8 (1 - dt / limit))^(-1/2): a hundredfold only within 2e-5 of it.)
constexpr double grown = 4.6;

double dot(const Field<double>& a, const Field<double>& b) {
    return std::inner_product(a.flat().begin(), a.flat().end(), b.flat().begin(), 0.0);
}

/// a(x), computed by the layout's own engine.
Field<double> accelerations(const Forces& forces, const Field<double>& x) {
    Field<double> a(x.count());
    std::visit([&](const auto& layout) { engine<double>(layout).accelerations(x, a); }, forces);
    return a;
}

struct Balancer {
    const Field<double>& start;

    void operator()(ConstantForces& forces) const { forces.step = 0; }
    void operator()(LineForces& forces) const { forces.gravity = 0; }
    void operator()(GridForces&) const {}  // starts relaxed
    void operator()(PairForces& forces) const { balance(forces); }
    void operator()(NearPairForces& forces) const { balance(forces); }

    template <class Pair>
    void balance(Pair& forces) const {
        forces.balance = std::make_shared<const Field<double>>(accelerations(forces, start));
    }
};

}  // namespace

Scene balanced(Scene scene) {
    const Field<double> start = scene.start.state().displacement;
    std::visit(Balancer{start}, scene.forces);
    return scene;
}

/// Displacement and velocity along the mode, in units of its shape.
struct ModeRun::Motion {
    double x = 0, v = 0;

    double size(double rate) const { return std::hypot(x, v / rate); }
};

ModeRun::ModeRun(const Method& method, const ParameterValues& parameters, Precision precision, const Scene& scene,
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
}

template <class Look>
double ModeRun::take(Motion& motion, double dt, std::uint64_t steps, Look look) const {
    const double before = motion.size(rate_), norm = dot(shape_, shape_);
    const Field<double>& start = start_;
    State<double> state{start, Field<double>(start.count())};
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) {
        state.displacement.flat()[k] += motion.x / before * shape_.flat()[k];
        state.velocity.flat()[k] = motion.v / before * shape_.flat()[k];
    }
    const auto stepper = method_.make({scene_, state, parameters_, precision_, dt});
    for (std::uint64_t step = 0; step < steps; ++step) {
        stepper->advance(1);
        stepper->synchronised(state);
        for (std::size_t k = 0; k < shape_.flat().size(); ++k) state.displacement.flat()[k] -= start.flat()[k];
        motion = {dot(shape_, state.displacement) / norm, dot(shape_, state.velocity) / norm};
        look(std::log(motion.size(rate_)));
    }
    return std::log(motion.size(rate_));
}

bool ModeRun::grows(double dt, std::uint64_t steps, double allowed) const {
    const FlushSubnormals flush;
    const auto block =
        static_cast<std::uint64_t>(std::clamp(departed / (departure_ * dt), 1.0, static_cast<double>(longest_block)));
    Motion motion{1, rate_};
    double size = 0, early = -infinity, late = -infinity;
    std::uint64_t step = 0;
    const auto look = [&](double factor) {
        ++step;
        if (step > steps / 8 && step <= steps / 8 * 3) early = std::max(early, size + factor);
        if (step > steps / 8 * 6) late = std::max(late, size + factor);
    };
    while (step < steps && size < grown) {
        check_interruption();
        size += take(motion, dt, block, look);
        if (!(size < infinity)) return true;  // beyond all numbers
    }
    return size >= grown || late > early + allowed;
}

double ModeRun::nonlinearity() const {
    Field<double> x = start_;
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) x.flat()[k] += shape_.flat()[k];
    const Field<double> there = accelerations(scene_.forces, x);
    const Field<double> here = accelerations(scene_.forces, start_);
    double difference = 0;
    for (std::size_t k = 0; k < shape_.flat().size(); ++k) {
        const double rest = there.flat()[k] - here.flat()[k] + omega_ * omega_ * shape_.flat()[k];
        difference += rest * rest;
    }
    return std::sqrt(difference / dot(shape_, shape_)) / (rate_ * rate_);
}

}  // namespace steplab
