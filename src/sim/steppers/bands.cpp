#include "sim/steppers/bands.hpp"

#include "core/flush_subnormals.hpp"
#include "core/team.hpp"
#include "sim/steppers/reordered.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace steplab {

namespace {

/// What a chain or grid is cut across: particles, or rows of them. No units: a scene that is not cut.
struct Units {
    std::size_t count = 0;
    std::size_t particles = 1;  ///< of each
};

Units units_of(const LineForces& forces) { return {forces.count, 1}; }
Units units_of(const GridForces& forces) { return {forces.rows, forces.columns}; }
template <class Other>
Units units_of(const Other&) {
    return {};
}
Units units_of(const Forces& forces) {
    return std::visit([](const auto& layout) { return units_of(layout); }, forces);
}

/// The forces on `count` units from this one on, as far as they come from within.
void cut(LineForces& forces, std::size_t first, std::size_t count) {
    forces.first_fixed = forces.first_fixed && first == 0;
    forces.count = count;
}
void cut(GridForces& forces, std::size_t, std::size_t count) { forces.rows = count; }
template <class Other>
void cut(Other&, std::size_t, std::size_t) {}

/// The part of a band that its borders may take on either side.
constexpr std::size_t band_over_border = 30;
/// Steps from one meeting to the next, at most.
constexpr std::size_t most_steps = 64;

/// Units from `begin` to `end`, with borders of units that belong to others: they are stepped along for as many steps
/// as it takes what is wrong at their ends to come in, and then taken from their owners again.
struct Band {
    std::size_t begin, end;
    std::size_t before, behind;  ///< units of the borders
    std::unique_ptr<Stepper> stepper;

    std::size_t first() const { return begin - before; }
};

/// Bands of a scene, each stepped by a thread of its own. Every particle moves as it would with all of the scene in one
/// piece, to the last bit.
class Bands final : public Stepper {
public:
    Bands(const Method& method, const StepperSetup& setup, Units units, std::size_t threads, std::size_t reach)
        : unit_(units.particles), particles_(units.count * units.particles), team_(threads) {
        const std::size_t count = team_.members();
        together_ = std::clamp<std::size_t>(units.count / count / (band_over_border * reach), 1, most_steps);
        const std::size_t border = together_ * reach;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t begin = units.count * i / count, end = units.count * (i + 1) / count;
            bands_.push_back({begin, end, std::min(begin, border), std::min(units.count - end, border), nullptr});
        }
        for (Band& band : bands_) make(band, method, setup);
    }

    void advance(std::uint64_t steps) override {
        const FlushSubnormals flush;
        team_.run([&](std::size_t i) {
            for (std::uint64_t left = steps; left > 0;) {
                const std::uint64_t taken = std::min<std::uint64_t>(left, together_);
                bands_[i].stepper->advance(taken);
                left -= taken;
                team_.meet();
                // every other band first: what one takes over changes it, and its neighbours read that
                for (const std::size_t turn : {0U, 1U}) {
                    if (i % 2 == turn) renew_borders(i);
                    team_.meet();
                }
            }
        });
    }

    bool finite() const override {
        std::vector<char> found(bands_.size());
        team_.run([&](std::size_t i) { found[i] = bands_[i].stepper->finite(); });
        return std::count(found.begin(), found.end(), char(false)) == 0;
    }

    std::size_t particles() const override { return particles_; }

    void emit(const PortionSink& sink) const override {
        for (std::size_t i = 0; i < bands_.size(); ++i) look_at(i, 0, sink);
    }
    void emit_parallel(const PortionSink& sink) const override {
        team_.share(bands_.size(), [&](std::size_t i) { look_at(i, i, sink); });
    }
    std::size_t parts() const override { return bands_.size(); }

    std::uint64_t evaluations() const override { return bands_.front().stepper->evaluations(); }

    void save(std::any& to) const override {
        const Saved* const before = std::any_cast<Saved>(&to);
        if (!before || before->size() != bands_.size()) to = Saved(bands_.size());
        Saved& saved = *std::any_cast<Saved>(&to);
        team_.share(bands_.size(), [&](std::size_t i) { bands_[i].stepper->save(saved[i]); });
    }
    void restore(const std::any& state) override {
        const Saved& saved = std::any_cast<const Saved&>(state);
        for (std::size_t i = 0; i < bands_.size(); ++i) bands_[i].stepper->restore(saved[i]);
    }
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Band& band : bands_) sum += band.stepper->bytes();
        return sum;
    }

    std::optional<std::size_t> reach() const override { return std::nullopt; }
    void take_over(const Stepper&, std::size_t, std::size_t, std::size_t) override {}

private:
    using Saved = std::vector<std::any>;

    void make(Band& band, const Method& method, const StepperSetup& setup) const {
        const std::size_t count = band.before + band.end - band.begin + band.behind;
        Plan scene{.mass = setup.scene.mass,
                   .drag = setup.scene.drag,
                   .forces = setup.scene.forces,
                   .reference = setup.scene.reference,
                   .start = {}};
        std::visit([&](auto& layout) { cut(layout, band.first(), count); }, scene.forces);
        band.stepper = method.make({scene, setup.start.part(band.first() * unit_, count * unit_), setup.parameters,
                                    setup.precision, setup.dt, setup.instructions});
    }

    /// What a band owns, as this part of the scene.
    void look_at(std::size_t i, std::size_t part, const PortionSink& sink) const {
        const Band& band = bands_[i];
        const std::size_t begin = band.begin * unit_, end = band.end * unit_, first = band.first() * unit_;
        band.stepper->emit([&](const Portion& portion) {
            const std::size_t from = first + portion.first, to = from + portion.count;
            const std::size_t own = std::max(from, begin);
            if (own < std::min(to, end))
                sink({own, std::min(to, end) - own, portion.state, portion.place + own - from, part});
        });
    }

    /// From the neighbours, who own them.
    void renew_borders(std::size_t i) {
        Band& band = bands_[i];
        const auto take = [&](std::size_t from_band, std::size_t begin, std::size_t end) {
            const Band& owner = bands_[from_band];
            band.stepper->take_over(*owner.stepper, (begin - owner.first()) * unit_, (begin - band.first()) * unit_,
                                    (end - begin) * unit_);
        };
        if (band.before > 0) take(i - 1, band.begin - band.before, band.begin);
        if (band.behind > 0) take(i + 1, band.end, band.end + band.behind);
    }

    std::size_t unit_;
    std::size_t particles_;
    std::size_t together_ = 1;  ///< steps from one meeting to the next
    std::vector<Band> bands_;
    mutable Team team_;
};

/// Units that a step reaches, none if there is no bound: asked of a scene of three units.
std::optional<std::size_t> reach_of(const Method& method, const StepperSetup& setup, const Units& units) {
    Plan scene{.mass = setup.scene.mass,
               .drag = setup.scene.drag,
               .forces = setup.scene.forces,
               .reference = setup.scene.reference,
               .start = {}};
    std::visit([](auto& layout) { cut(layout, 0, 3); }, scene.forces);
    return method
        .make({scene, setup.start.part(0, 3 * units.particles), setup.parameters, setup.precision, setup.dt,
               setup.instructions})
        ->reach();
}

/// A particle whose pairs are summed, or whose springs join it with any others, takes at least as long as this number
/// of particles with springs in a line.
constexpr std::size_t time_of_pairs = 5;

/// Threads that slabs are enough for (Clusters::slabs()), about.
std::size_t most_threads(std::size_t particles) {
    return static_cast<std::size_t>(std::cbrt(static_cast<double>(particles)) / 6);
}

/// Of those allowed, as many threads as it takes.
std::size_t paying_threads(const Execution& execution, std::size_t particles) {
    const std::size_t allowed = execution.threads > 0 ? execution.threads : processors();
    return std::min(allowed, particles / std::max<std::size_t>(1, execution.particles_a_thread));
}

/// The bands that a scene is divided into, and the units that a step reaches.
struct Division {
    std::size_t bands = 1, reach = 0;
};

Division division_of(const Method& method, const StepperSetup& setup, const Units& units, const Execution& execution) {
    const std::size_t paying = paying_threads(execution, units.count * units.particles);
    if (paying < 2 || units.count < 3) return {};
    const auto reach = reach_of(method, setup, units);
    // a border lies in the neighbouring band alone
    const std::size_t count = reach ? std::min(paying, units.count / (2 * *reach)) : 1;
    return count > 1 ? Division{count, *reach} : Division{};
}

// Threads that share the sums of a scene in one piece.

std::size_t most_threads(const NearPairForces& forces) { return most_threads(forces.count); }
std::size_t most_threads(const ComposedForces& forces) {
    const Composition& terms = *forces.terms;
    const bool cut = std::any_of(terms.pairs.begin(), terms.pairs.end(), [](const auto& p) { return p.cutoff > 0; });
    if (cut) return most_threads(forces.count);
    return terms.springs.empty() ? 1 : forces.count;
}
template <class Other>
std::size_t most_threads(const Other&) {
    return 1;
}

std::size_t threads_of_sums(const Plan& scene, const Execution& execution) {
    const std::size_t most = std::visit([](const auto& forces) { return most_threads(forces); }, scene.forces);
    const std::size_t threads = std::min(paying_threads(execution, scene.start.count() * time_of_pairs), most);
    return std::max<std::size_t>(1, threads);
}

template <class Other>
void set_threads(Other& forces, std::size_t threads) {
    if constexpr (requires { forces.threads; }) forces.threads = threads;
}

/// In one piece, whose forces may be summed by several threads.
std::unique_ptr<Stepper> make_whole(const Method& method, const StepperSetup& setup, const Execution& execution) {
    Plan scene = setup.scene;
    const std::size_t threads = threads_of_sums(scene, execution);
    std::visit([&](auto& forces) { set_threads(forces, threads); }, scene.forces);
    const StepperSetup whole{scene, setup.start, setup.parameters, setup.precision, setup.dt, setup.instructions};
    auto order = order_by_place(scene);
    return order.empty() ? method.make(whole)
                         : make_reordered(whole, std::move(order),
                                          [&](const StepperSetup& reordered) { return method.make(reordered); });
}

}  // namespace

std::unique_ptr<Stepper> make_stepper(const Method& method, const StepperSetup& setup, const Execution& execution) {
    const Units units = units_of(setup.scene.forces);
    const Division division = division_of(method, setup, units, execution);
    if (division.bands > 1) return std::make_unique<Bands>(method, setup, units, division.bands, division.reach);
    return make_whole(method, setup, execution);
}

std::size_t threads_for(const Method& method, const StepperSetup& setup, const Execution& execution) {
    const std::size_t bands = division_of(method, setup, units_of(setup.scene.forces), execution).bands;
    return bands > 1 ? bands : threads_of_sums(setup.scene, execution);
}

}  // namespace steplab
