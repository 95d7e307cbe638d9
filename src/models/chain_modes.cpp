#include "models/chain_modes.hpp"

#include "models/forces/linear_response.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace steplab {

namespace {

using Real = long double;

/// theta_j = (2 j - 1) pi / (2 N + 1), the wave number of mode j of N particles behind a fixed one.
Real fixed_angle(std::size_t j, std::size_t moving) {
    return (2 * static_cast<Real>(j) - 1) * std::numbers::pi_v<Real> / (2 * static_cast<Real>(moving) + 1);
}

/// pi q / n, q = j - 1, the wave number of mode j of a free chain.
Real free_angle(std::size_t j, std::size_t count) {
    return static_cast<Real>(j - 1) * std::numbers::pi_v<Real> / static_cast<Real>(count);
}

Real exact_frequency(const ChainModes& modes, std::size_t j) {
    const Real angle = modes.first_fixed ? fixed_angle(j, modes.modes()) : free_angle(j, modes.count);
    return 2 * std::sqrt(modes.k_over_m) * std::sin(angle / 2);
}

Real exact_shape(const ChainModes& modes, std::size_t j, std::size_t particle) {
    const Real i = static_cast<Real>(particle), n = static_cast<Real>(modes.count), half = 0.5L;
    if (modes.first_fixed) {
        const Real angle = fixed_angle(j, modes.modes());
        return 4 / (2 * n - 1) * std::sin(i * angle) * std::sin((n - 1) * angle);
    }
    const Real angle = free_angle(j, modes.count);
    return (j == 1 ? 1 : 2) / n * std::cos((i + half) * angle) * std::cos((n - half) * angle);
}

/// In long double, so that the sum is accurate to the last bits of a double at any time.
class ChainSolution final : public ExactSolution {
public:
    ChainSolution(const ChainModes& modes, double v0) : modes_(modes), v0_(v0) {
        for (std::size_t j = 1; j <= modes.modes(); ++j) {
            const Real frequency = exact_frequency(modes, j);
            omega2_.push_back(frequency * frequency);
        }
        for (std::size_t i = 0; i < modes.count; ++i) {
            for (std::size_t j = 1; j <= modes.modes(); ++j) shapes_.push_back(exact_shape(modes, j, i));
        }
    }

    Vec3 displacement(std::size_t particle, double t) const override { return {sum(particle, responses(t)), 0, 0}; }

    Vec3 velocity(std::size_t particle, double t) const override {
        std::vector<Real> rates;
        for (const Real omega2 : omega2_) rates.push_back(v0_ * KickResponse(omega2, modes_.drag, t).g_rate);
        return {sum(particle, rates), 0, 0};
    }

    void displacements(double t, std::span<Vec3> out) const override {
        const std::vector<Real> all = responses(t);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = {sum(i, all), 0, 0};
    }

    /// The responses of the modes are bounded by that of the slowest one, and their shapes add up to less than 2.
    double rounding(double t) const override {
        return 2 * mode_rounding(v0_, std::sqrt(omega2_.front()), t) + 1e-19 * std::abs(static_cast<double>(v0_)) * t;
    }

private:
    std::vector<Real> responses(double t) const {
        std::vector<Real> all;
        all.reserve(omega2_.size());
        for (const Real omega2 : omega2_) all.push_back(v0_ * KickResponse(omega2, modes_.drag, t).g);
        return all;
    }

    double sum(std::size_t particle, const std::vector<Real>& all) const {
        const auto shapes = shapes_.begin() + static_cast<std::ptrdiff_t>(particle * all.size());
        return static_cast<double>(std::inner_product(all.begin(), all.end(), shapes, Real(0)));
    }

    ChainModes modes_;
    Real v0_;
    std::vector<Real> omega2_;
    std::vector<Real> shapes_;  ///< of each particle in each mode
};

}  // namespace

double ChainModes::frequency(std::size_t j) const { return static_cast<double>(exact_frequency(*this, j)); }

double ChainModes::shape(std::size_t j, std::size_t particle) const {
    return static_cast<double>(exact_shape(*this, j, particle));
}

std::shared_ptr<const ExactSolution> chain_solution(const ChainModes& modes, double v0) {
    return std::make_shared<ChainSolution>(modes, v0);
}

}  // namespace steplab
