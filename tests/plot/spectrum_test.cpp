#include "plot/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace steplab::plot {
namespace {

constexpr double interval = 0.05;

std::vector<double> sampled(int count, const std::function<double(double)>& signal) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(signal(interval * i));
    return values;
}

struct Peak {
    double frequency = 0, amplitude = 0;
};

/// Above a frequency.
Peak highest(const Spectrum& spectrum, double from = 0) {
    Peak peak;
    for (std::size_t i = 0; i < spectrum.frequencies.size(); ++i) {
        if (spectrum.frequencies[i] > from && spectrum.amplitudes[i] > peak.amplitude)
            peak = {spectrum.frequencies[i], spectrum.amplitudes[i]};
    }
    return peak;
}

double step_of(const Spectrum& spectrum) { return spectrum.frequencies[1] - spectrum.frequencies[0]; }

// Also of frequencies and lengths that do not fit each other; half a step is the farthest from a frequency.
TEST(spectrum, of_a_vibration_is_a_peak_of_its_frequency_and_amplitude) {
    for (const double frequency : {0.7, 1.0, 2.345, 11.1}) {
        for (const int count : {1000, 1024, 1777}) {
            const auto values = sampled(count, [&](double t) { return 3 + 0.25 * std::cos(frequency * t + 1); });
            const Spectrum found = spectrum(values, interval);
            const Peak peak = highest(found);
            EXPECT_NEAR(peak.frequency, frequency, 0.51 * step_of(found)) << count;
            EXPECT_LE(peak.amplitude, 0.25 * 1.01) << count;
            EXPECT_GE(peak.amplitude, 0.25 * 0.95) << count;
        }
    }
}

TEST(spectrum, goes_from_above_zero_to_two_values_a_period) {
    const Spectrum found = spectrum(sampled(100, [](double t) { return std::sin(t); }), interval);
    EXPECT_EQ(found.frequencies.size(), found.amplitudes.size());
    EXPECT_GT(found.frequencies.front(), 0);
    EXPECT_NEAR(found.frequencies.back(), std::numbers::pi / interval, 1e-9);
}

// Without a window the strong vibration would cover the weak one by leakage of a hundredth.
TEST(spectrum, shows_a_weak_vibration_beside_a_strong_one) {
    const Spectrum found =
        spectrum(sampled(2000, [](double t) { return std::cos(1.03 * t) + 1e-4 * std::cos(9.77 * t); }), interval);
    const Peak weak = highest(found, 5);
    EXPECT_NEAR(weak.frequency, 9.77, 0.51 * step_of(found));
    EXPECT_NEAR(weak.amplitude, 1e-4, 1e-5);
}

TEST(spectrum, of_a_constant_is_rounding) {
    const Spectrum found = spectrum(sampled(500, [](double) { return 7; }), interval);
    EXPECT_LT(highest(found).amplitude, 1e-13);
    const Spectrum moving = spectrum(sampled(500, [](double t) { return 7 + 1e-6 * std::sin(3 * t); }), interval);
    EXPECT_GT(highest(moving).amplitude, 9e-7);
}

}  // namespace
}  // namespace steplab::plot
