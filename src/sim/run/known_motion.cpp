#include "sim/run/known_motion.hpp"

#include "models/forces/linear_response.hpp"
#include "sim/run/fixed_particles.hpp"
#include "sim/run/kepler_motion.hpp"
#include "sim/run/known_fall.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace steplab {

namespace {

using Real = long double;
using RealColumn = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// All modes of more particles take too long to find in long double.
constexpr std::size_t most_particles = 200;
constexpr Real unit = std::numeric_limits<Real>::epsilon();

/// A linear spring along x: it pulls its first particle by k (u_second - u_first + strain).
struct LineSpring {
    std::size_t first, second;
    Real k, strain, length;
};

/// Linear springs along x, and what moves on them, by the square roots of the masses.
struct LineSystem {
    std::vector<LineSpring> springs;
    std::vector<Eigen::Index> place;  ///< of each particle among those that move; -1: fixed
    std::vector<Real> root_mass, u, v;
    Eigen::Index moving = 0;
};

bool along_x(Vec3 v) { return v.y == 0 && v.z == 0; }

void add_particles(const Plan& plan, LineSystem& system) {
    for (std::size_t i = 0; i < plan.reference.count; ++i) {
        const Start::Particle particle = plan.start[i];
        system.place.push_back(is_fixed(plan.forces, i) ? -1 : system.moving++);
        system.root_mass.push_back(std::sqrt(Real(plan.mass) * (plan.masses.empty() ? 1 : plan.masses[i])));
        system.u.push_back(particle.displacement.x);
        system.v.push_back(particle.velocity.x);
    }
}

bool starts_along_x(const Plan& plan) {
    for (std::size_t i = 0; i < plan.reference.count; ++i) {
        const Start::Particle particle = plan.start[i];
        if (!along_x(particle.displacement) || !along_x(particle.velocity)) return false;
    }
    return true;
}

/// False if two particles are at one place, where a spring has no direction.
bool add_spring(const ComposedSpring& spring, LineSystem& system) {
    const Real distance = Real(spring.rest.x) + system.u[spring.second] - system.u[spring.first];
    if (distance == 0 && spring.length != 0) return false;
    const Real length = distance < 0 ? -Real(spring.length) : Real(spring.length);
    system.springs.push_back({spring.first, spring.second, spring.k, Real(spring.rest.x) - length, length});
    return along_x(spring.rest) && spring.quadratic == 0 && spring.cubic == 0;
}

std::vector<ComposedSpring> springs_of(const LineForces& line) {
    std::vector<ComposedSpring> springs;
    for (std::size_t i = 0; i + 1 < line.count; ++i)
        springs.push_back({.first = static_cast<std::uint32_t>(i),
                           .second = static_cast<std::uint32_t>(i + 1),
                           .rest = {line.rest_length, 0, 0},
                           .length = line.rest_length,
                           .k = line.k});
    return springs;
}

/// Nothing if other forces act, or other motions are possible.
std::optional<LineSystem> line_system(const Plan& plan) {
    if (plan.reference.count > most_particles) return std::nullopt;
    std::vector<ComposedSpring> springs;
    if (const auto* const line = std::get_if<LineForces>(&plan.forces); line && line->gravity == 0) {
        springs = springs_of(*line);
    } else if (const auto* const composed = std::get_if<ComposedForces>(&plan.forces)) {
        const Composition& terms = *composed->terms;
        if (!terms.pairs.empty() || !terms.accelerations.empty() || !terms.fields.empty() || terms.is_damped() ||
            terms.box != Vec3{})
            return std::nullopt;
        springs = terms.springs;
    }
    if (springs.empty() || !starts_along_x(plan)) return std::nullopt;
    LineSystem system;
    add_particles(plan, system);
    for (const ComposedSpring& spring : springs) {
        if (!add_spring(spring, system)) return std::nullopt;
    }
    return system;
}

/// One mode: q'' = -omega2 (q - rest) - gamma q'.
struct Mode {
    Real omega2 = 0, rest = 0, q = 0, rate = 0;

    Real omega() const { return std::sqrt(omega2); }
    /// The largest |q - rest| at any time, as its energy never grows; of a motion without spring it is not asked.
    Real amplitude() const { return omega2 > 0 ? std::hypot(q - rest, rate / omega()) : 0; }
};

class LineMotion final : public ExactSolution {
public:
    LineMotion(LineSystem system, Real drag) : system_(std::move(system)), drag_(drag) {
        const Eigen::Index n = system_.moving;
        if (n == 0) return;  // all are fixed; there is nothing to solve
        RealMatrix stiffness = RealMatrix::Zero(n, n);
        RealColumn force = RealColumn::Zero(n);
        for (const LineSpring& spring : system_.springs) add(spring, stiffness, force);
        const Eigen::SelfAdjointEigenSolver<RealMatrix> solver(stiffness);
        vectors_ = solver.eigenvectors();
        force = vectors_.transpose() * force;
        largest_ = solver.eigenvalues()[n - 1];
        for (Eigen::Index k = 0; k < n; ++k) modes_.push_back(mode(k, solver.eigenvalues()[k], force[k]));
    }

    /// False if a motion without spring is pushed, or a particle may come to pass another.
    bool valid() const { return at_rest_ && (by_energy() || by_modes()); }

    Vec3 displacement(std::size_t i, double t) const override {
        return {static_cast<double>(of(
                    i, t,
                    [this](const Mode& mode, Real at) {
                        const KickResponse kick(mode.omega2, drag_, at);
                        if (mode.omega2 == 0) return mode.q + mode.rate * kick.g;
                        return mode.rest + (mode.q - mode.rest) * (kick.g_rate + drag_ * kick.g) + mode.rate * kick.g;
                    },
                    system_.u[i])),
                0, 0};
    }
    Vec3 velocity(std::size_t i, double t) const override {
        return {static_cast<double>(of(
                    i, t,
                    [this](const Mode& mode, Real at) {
                        const KickResponse kick(mode.omega2, drag_, at);
                        return mode.rate * kick.g_rate - (mode.q - mode.rest) * mode.omega2 * kick.g;
                    },
                    0)),
                0, 0};
    }
    /// Of the phases, and of the frequencies, which are known to some units of the largest.
    double rounding(double t) const override {
        Real sum = 0;
        const Real count = static_cast<Real>(modes_.size());
        for (const Mode& mode : modes_) {
            const Real omega = mode.omega(), size = mode.omega2 > 0 ? mode.amplitude() : std::abs(mode.rate) * t;
            const Real drift = omega > 0 ? count * largest_ / omega : 0;
            sum += (size + std::abs(mode.q) + std::abs(mode.rest)) * 2 * unit * (4 + count + (omega + drift) * t);
        }
        const Real lightest = *std::min_element(system_.root_mass.begin(), system_.root_mass.end());
        return static_cast<double>(sum / lightest);
    }

private:
    template <class Value>
    Real of(std::size_t i, double t, const Value& value, Real if_fixed) const {
        const Eigen::Index row = system_.place[i];
        if (row < 0) return if_fixed;
        Real sum = 0;
        for (std::size_t k = 0; k < modes_.size(); ++k)
            sum += vectors_(row, static_cast<Eigen::Index>(k)) * value(modes_[k], Real(t));
        return sum / system_.root_mass[i];
    }

    /// Its stiffness, and its force where all that moves is at u = 0.
    void add(const LineSpring& spring, RealMatrix& stiffness, RealColumn& force) const {
        const auto [i, j] = std::pair{system_.place[spring.first], system_.place[spring.second]};
        const Real first = system_.root_mass[spring.first], second = system_.root_mass[spring.second];
        const Real pull =
            spring.k * (spring.strain + (j < 0 ? system_.u[spring.second] : 0) - (i < 0 ? system_.u[spring.first] : 0));
        if (i >= 0) stiffness(i, i) += spring.k / (first * first), force[i] += pull / first;
        if (j >= 0) stiffness(j, j) += spring.k / (second * second), force[j] -= pull / second;
        if (i >= 0 && j >= 0) stiffness(i, j) -= spring.k / (first * second), stiffness(j, i) = stiffness(i, j);
    }

    Mode mode(Eigen::Index k, Real eigenvalue, Real force) {
        Mode mode{.omega2 = eigenvalue > 64 * static_cast<Real>(system_.moving) * unit * largest_ ? eigenvalue : 0};
        Real scale = 0;
        for (std::size_t i = 0; i < system_.place.size(); ++i) {
            if (system_.place[i] < 0) continue;
            const Real part = vectors_(system_.place[i], k) * system_.root_mass[i];
            mode.q += part * system_.u[i];
            mode.rate += part * system_.v[i];
        }
        for (const LineSpring& spring : system_.springs) scale += spring.k * std::abs(spring.length);
        if (mode.omega2 > 0) mode.rest = force / mode.omega2;
        const Real lightest = *std::min_element(system_.root_mass.begin(), system_.root_mass.end());
        at_rest_ = at_rest_ && (mode.omega2 > 0 || std::abs(force) * lightest <= 1e3L * unit * scale);
        return mode;
    }

    Real part_of_spring(const LineSpring& spring, Eigen::Index k) const {
        const auto end = [&](std::size_t particle) {
            const Eigen::Index row = system_.place[particle];
            return row < 0 ? 0 : vectors_(row, k) / system_.root_mass[particle];
        };
        return end(spring.second) - end(spring.first);
    }

    /// Springs that are relaxed at rest: none has the energy to be pressed to length 0.
    bool by_energy() const {
        Real twice_energy = 0;
        for (const Mode& mode : modes_) twice_energy += mode.omega2 * mode.amplitude() * mode.amplitude();
        return std::all_of(system_.springs.begin(), system_.springs.end(), [&](const LineSpring& spring) {
            const Real room = spring.k * spring.length * spring.length * (1 + 1e-12L);
            return spring.length == 0 ||
                   (std::abs(rest_of(spring) - spring.length) <= 1e-15L * std::abs(spring.length) &&
                    twice_energy <= room);
        });
    }

    /// Where all modes together leave every spring some length.
    bool by_modes() const {
        return std::all_of(system_.springs.begin(), system_.springs.end(), [&](const LineSpring& spring) {
            Real most = 0;
            for (std::size_t k = 0; k < modes_.size(); ++k)
                most += modes_[k].amplitude() * std::abs(part_of_spring(spring, static_cast<Eigen::Index>(k)));
            const Real rest = spring.length < 0 ? -rest_of(spring) : rest_of(spring);
            return spring.length == 0 || rest - most > 0;
        });
    }

    /// From its first to its second particle where all modes rest.
    Real rest_of(const LineSpring& spring) const {
        Real distance = spring.strain + spring.length;
        for (std::size_t k = 0; k < modes_.size(); ++k) {
            const Real at = modes_[k].omega2 > 0 ? modes_[k].rest : modes_[k].q;
            distance += at * part_of_spring(spring, static_cast<Eigen::Index>(k));
        }
        const auto fixed = [&](std::size_t i) { return system_.place[i] < 0 ? system_.u[i] : 0; };
        return distance + fixed(spring.second) - fixed(spring.first);
    }

    LineSystem system_;
    Real drag_;
    RealMatrix vectors_;
    std::vector<Mode> modes_;
    Real largest_ = 0;
    bool at_rest_ = true;  ///< nothing pushes a motion without spring
};

std::shared_ptr<const ExactSolution> line_motion(const Plan& plan) {
    std::optional<LineSystem> system = line_system(plan);
    if (!system) return nullptr;
    auto motion = std::make_shared<LineMotion>(std::move(*system), plan.drag);
    return motion->valid() ? motion : nullptr;
}

}  // namespace

std::shared_ptr<const ExactSolution> known_motion(const Plan& plan) {
    if (auto motion = kepler_motion(plan)) return motion;
    if (auto motion = known_fall(plan)) return motion;
    return line_motion(plan);
}

}  // namespace steplab
