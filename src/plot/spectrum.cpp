#include "plot/spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace steplab::plot {
namespace {

std::vector<double> hann(std::size_t count) {
    std::vector<double> weights(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double s = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
        weights[i] = s * s;
    }
    return weights;
}

/// The mean by these weights is that which leaves nothing at frequency 0.
double weighted_mean(std::span<const double> values, std::span<const double> weights) {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += weights[i] * values[i];
        all += weights[i];
    }
    return sum / all;
}

}  // namespace

Spectrum spectrum(std::span<const double> values, double interval) {
    const std::vector<double> weights = hann(values.size());
    const double mean = weighted_mean(values, weights);
    // Zeros behind the values: frequencies twice as close show the height of a peak between two of them.
    std::vector<double> signal(2 * std::bit_ceil(values.size()), 0.0);
    double all = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        signal[i] = weights[i] * (values[i] - mean);
        all += weights[i];
    }
    std::vector<std::complex<double>> transformed;
    Eigen::FFT<double>().fwd(transformed, signal);
    Spectrum found;
    const double step = 2 * std::numbers::pi / (static_cast<double>(signal.size()) * interval);
    for (std::size_t k = 1; k <= signal.size() / 2; ++k) {
        found.frequencies.push_back(static_cast<double>(k) * step);
        found.amplitudes.push_back(2 * std::abs(transformed[k]) / all);
    }
    return found;
}

}  // namespace steplab::plot
