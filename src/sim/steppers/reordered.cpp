#include "sim/steppers/reordered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

namespace steplab {

namespace {

/// From as many particles on the order matters: fewer fit the first caches in any.
constexpr std::size_t many = 2000;
/// Particles that may stand in any order among each other: they fit the first-level cache together.
constexpr std::size_t together = 128;

using Order = std::vector<std::uint32_t>;

/// The place of each particle in an order.
Order places_in(const Order& order) {
    Order places(order.size());
    for (std::uint32_t place = 0; place < order.size(); ++place) places[order[place]] = place;
    return places;
}

/// The bits of a coordinate, each followed by two zeros.
std::uint64_t spread_bits(std::uint64_t coordinate) {
    std::uint64_t spread = 0;
    for (unsigned bit = 0; bit < 21; ++bit) spread |= (coordinate >> bit & 1) << (3 * bit);
    return spread;
}

/// Positions along a curve that fills space (Z-order; Morton, IBM report, 1966), as its numbers.
std::vector<std::uint64_t> along_curve(const Plan& scene) {
    std::vector<Vec3> at(scene.start.count());
    std::array<double, 3> low, high;
    low.fill(INFINITY), high.fill(-INFINITY);
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = scene.reference.at(i) + scene.start[i].displacement;
        const std::array<double, 3> position{at[i].x, at[i].y, at[i].z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], position[axis]);
            high[axis] = std::max(high[axis], position[axis]);
        }
    }
    const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const double scale = side > 0 && std::isfinite(side) ? 2097151 / side : 0;
    std::vector<std::uint64_t> numbers(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto bits = [&](double x, double from) {
            return spread_bits(static_cast<std::uint64_t>((x - from) * scale));
        };
        numbers[i] = bits(at[i].x, low[0]) | bits(at[i].y, low[1]) << 1 | bits(at[i].z, low[2]) << 2;
    }
    return numbers;
}

/// The numbers of springs of particles.
std::vector<std::uint32_t> springs_of(const Composition& terms) {
    std::vector<std::uint32_t> springs(terms.count);
    for (const ComposedSpring& spring : terms.springs) ++springs[spring.first], ++springs[spring.second];
    return springs;
}

template <class T>
void reorder(std::vector<T>& numbers, const Order& order) {
    if (numbers.size() != order.size()) return;  // one for all, or none
    std::vector<T> reordered;
    for (const std::uint32_t i : order) reordered.push_back(numbers[i]);
    numbers = std::move(reordered);
}

Composition reordered(Composition terms, const Order& order) {
    const Order places = places_in(order);
    reorder(terms.masses, order), reorder(terms.charges, order), reorder(terms.fixed, order);
    reorder(terms.reference, order), reorder(terms.drag, order), reorder(terms.accelerations, order);
    for (ComposedSpring& spring : terms.springs)
        spring.first = places[spring.first], spring.second = places[spring.second];
    for (ComposedField& field : terms.fields) {
        for (std::uint32_t& particle : field.particles) particle = places[particle];
    }
    return terms;
}

Start reordered(const Start& start, const Order& order) {
    return {order.size(), [start, shared = std::make_shared<const Order>(order)](std::size_t place) {
                return start[(*shared)[place]];
            }};
}

Plan reordered(Plan scene, const Order& order) {
    auto& forces = std::get<ComposedForces>(scene.forces);
    forces.terms = std::make_shared<const Composition>(reordered(*forces.terms, order));
    scene.start = reordered(scene.start, order);
    reorder(scene.masses, order);
    if (scene.reference.points) {
        std::vector<Vec3> points = *scene.reference.points;
        reorder(points, order);
        scene.reference.points = std::make_shared<const std::vector<Vec3>>(std::move(points));
    }
    return scene;
}

class Reordered final : public Stepper {
public:
    Reordered(std::unique_ptr<Stepper> stepper, Order order)
        : stepper_(std::move(stepper)),
          order_(std::move(order)),
          seen_{Field<double>(order_.size()), Field<double>(order_.size())} {}

    void advance(std::uint64_t steps) override { stepper_->advance(steps); }
    bool finite() const override { return stepper_->finite(); }
    std::size_t particles() const override { return order_.size(); }

    void emit(const PortionSink& sink) const override {
        stepper_->emit([this](const Portion& portion) {
            for (std::size_t k = 0; k < portion.count; ++k) {
                const std::size_t i = order_[portion.first + k], from = portion.place + k;
                seen_.displacement.set(i, portion.state.displacement.at(from));
                seen_.velocity.set(i, portion.state.velocity.at(from));
            }
        });
        sink({0, order_.size(), seen_});
    }

    std::uint64_t evaluations() const override { return stepper_->evaluations(); }
    CollisionRecord collisions() const override { return stepper_->collisions().with_particles(order_); }
    std::optional<OwnStop> stopped() const override {
        std::optional<OwnStop> stop = stepper_->stopped();
        if (stop) stop->first = order_[stop->first], stop->second = order_[stop->second];
        return stop;
    }
    void count_drag_work(std::vector<double> coefficients) override {
        reorder(coefficients, order_);
        stepper_->count_drag_work(std::move(coefficients));
    }
    double drag_work() const override { return stepper_->drag_work(); }
    void save(std::any& to) const override { stepper_->save(to); }
    void restore(const std::any& saved) override { stepper_->restore(saved); }
    std::size_t bytes() const override { return stepper_->bytes(); }
    std::optional<std::size_t> reach() const override { return std::nullopt; }
    void take_over(const Stepper&, std::size_t, std::size_t, std::size_t) override {}  // of bands, which have no reach

private:
    std::unique_ptr<Stepper> stepper_;
    Order order_;
    mutable State<double> seen_;  ///< memory for emit()
};

}  // namespace

Order order_by_place(const Plan& scene) {
    const auto* const forces = std::get_if<ComposedForces>(&scene.forces);
    if (!forces || forces->count < many || forces->terms->springs.empty() || !forces->terms->pairs.empty()) return {};
    const std::vector<std::uint64_t> curve = along_curve(scene);
    const std::vector<std::uint32_t> springs = springs_of(*forces->terms);
    Order order(forces->count);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return curve[i] < curve[j]; });
    for (auto begin = order.begin(); begin != order.end();) {
        const auto end = begin + std::min<std::ptrdiff_t>(together, order.end() - begin);
        std::stable_sort(begin, end, [&](auto i, auto j) { return springs[i] < springs[j]; });
        begin = end;
    }
    return order;
}

std::unique_ptr<Stepper> make_reordered(const StepperSetup& setup, Order order,
                                        const std::function<std::unique_ptr<Stepper>(const StepperSetup&)>& make) {
    const Plan scene = reordered(setup.scene, order);
    auto stepper =
        make({scene, reordered(setup.start, order), setup.parameters, setup.precision, setup.dt, setup.instructions});
    return std::make_unique<Reordered>(std::move(stepper), std::move(order));
}

}  // namespace steplab
