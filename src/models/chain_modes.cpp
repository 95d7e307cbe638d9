#include "models/chain_modes.hpp"

#include "models/linear_response.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace steplab {

namespace {

/// theta_j = (2 j - 1) pi / (2 N + 1), the wave number of mode j of N particles behind a fixed one.
double fixed_angle(std::size_t j, std::size_t moving) {
    return (2 * static_cast<double>(j) - 1) * std::numbers::pi / (2 * static_cast<double>(moving) + 1);
}

/// pi q / n, q = j - 1, the wave number of mode j of a free chain.
double free_angle(std::size_t j, std::size_t count) {
    return static_cast<double>(j - 1) * std::numbers::pi / static_cast<double>(count);
}

class ChainSolution final : public ExactSolution {
public:
    ChainSolution(const ChainModes& modes, double v0) : modes_(modes), v0_(v0) {
        for (std::size_t j = 1; j <= modes.modes(); ++j) omega2_.push_back(std::pow(modes.frequency(j), 2));
        for (std::size_t i = 0; i < modes.count; ++i) {
            for (std::size_t j = 1; j <= modes.modes(); ++j) shapes_.push_back(modes.shape(j, i));
        }
    }

    Vec3 displacement(std::size_t particle, double t) const override { return {sum(particle, responses(t)), 0, 0}; }

    void displacements(double t, std::span<Vec3> out) const override {
        const std::vector<double> answers = responses(t);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = {sum(i, answers), 0, 0};
    }

private:
    std::vector<double> responses(double t) const {
        std::vector<double> answers;
        answers.reserve(omega2_.size());
        for (const double omega2 : omega2_) answers.push_back(v0_ * kick_response(omega2, modes_.drag, t));
        return answers;
    }

    double sum(std::size_t particle, const std::vector<double>& answers) const {
        return std::inner_product(answers.begin(), answers.end(),
                                  shapes_.begin() + static_cast<std::ptrdiff_t>(particle * answers.size()), 0.0);
    }

    ChainModes modes_;
    double v0_;
    std::vector<double> omega2_;
    std::vector<double> shapes_;  ///< of each particle in each mode
};

}  // namespace

double ChainModes::frequency(std::size_t j) const {
    const double angle = first_fixed ? fixed_angle(j, modes()) : free_angle(j, count);
    return 2 * std::sqrt(k_over_m) * std::sin(angle / 2);
}

double ChainModes::shape(std::size_t j, std::size_t particle) const {
    const double i = static_cast<double>(particle);
    const double n = static_cast<double>(count);
    if (first_fixed) {
        const double angle = fixed_angle(j, modes());
        return 4 / (2 * n - 1) * std::sin(i * angle) * std::sin((n - 1) * angle);
    }
    const double angle = free_angle(j, count);
    return (j == 1 ? 1 : 2) / n * std::cos((i + 0.5) * angle) * std::cos((n - 0.5) * angle);
}

std::shared_ptr<const ExactSolution> chain_solution(const ChainModes& modes, double v0) {
    return std::make_shared<ChainSolution>(modes, v0);
}

}  // namespace steplab
