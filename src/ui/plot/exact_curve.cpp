#include "ui/plot/exact_curve.hpp"

#include "ui/plot/run_curves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace steplab::ui {
namespace {

constexpr Vec3 nowhere{unknown, unknown, unknown};

/// Of the largest value: a fifth of a pixel where a plot is 100 pixels high.
constexpr double visible = 2e-3;

bool is_known(const ExactPoint& point) { return !std::isnan(point.displacement.x); }

/// Fewer between many samples, so that all points are a few times the samples at most; and of many particles, all of
/// which are summed up for each point, so few that the whole curve takes no longer than that of `usual` ones. Powers of
/// two, then: with another number the curve begins again.
std::size_t parts_between(std::size_t samples, std::size_t particles) {
    constexpr std::size_t most_points = 4 * RunSamples::most, usual = ExactCurve::most_particles_in_full;
    const std::size_t count = std::max<std::size_t>(samples, 1);
    const std::size_t parts = std::clamp<std::size_t>(most_points / count, 4, 16);
    if (particles <= usual) return parts;
    return std::clamp<std::size_t>(std::bit_floor(most_points * usual / particles / count), 1, parts);
}

}  // namespace

std::span<const ExactPoint> ExactCurve::of(const SampleSeries& series, std::size_t place,
                                           const std::optional<ExactMotion>& motion, std::size_t particles) {
    const std::size_t parts = parts_between(series.samples.size(), particles);
    if (!is_of(series, motion, parts)) *this = {};
    stretch_ = series.stretch;
    motion_ = motion ? motion : motion_;
    parts_ = parts;
    for (; used_ < series.samples.size(); ++used_)
        add(series.samples[used_].time, series.samples[used_].particle(place));
    return known_ ? points_ : std::span<const ExactPoint>();
}

bool ExactCurve::is_of(const SampleSeries& series, const std::optional<ExactMotion>& motion, std::size_t parts) const {
    return series.stretch == stretch_ && used_ <= series.samples.size() && parts == parts_ &&
           (!motion || motion == motion_);
}

void ExactCurve::add(double time, const Sample::Particle* known) {
    if (!known || !known->exact_displacement) {
        points_.push_back({time, nowhere, nowhere});
        return;
    }
    const Vec3 velocity = motion_ ? motion_->velocity(time) : nowhere;
    const ExactPoint here{time, *known->exact_displacement, velocity};
    farthest_ = std::max(farthest_, length(here.displacement));
    if (motion_) fastest_ = std::max(fastest_, length(velocity));
    if (motion_ && parts_ > 1 && !points_.empty() && is_known(points_.back())) fill(here);
    points_.push_back(here);
    known_ = true;
}

ExactPoint ExactCurve::point_at(double time) const {
    return {time, motion_->displacement(time).value_or(nowhere), motion_->velocity(time)};
}

/// The time from the last point to this one. Three points between them tell a wave from a line, also one of which both
/// are the same moment of its period.
void ExactCurve::fill(const ExactPoint& to) {
    const ExactPoint from = points_.back();
    const auto between = [&](double part) { return from.time + part * (to.time - from.time); };
    const auto is_off = [&](double part) {
        const ExactPoint there = point_at(between(part));
        const Vec3 off = there.displacement - ((1 - part) * from.displacement + part * to.displacement);
        const Vec3 faster = there.velocity - ((1 - part) * from.velocity + part * to.velocity);
        return length(off) > visible * farthest_ || length(faster) > visible * fastest_;
    };
    if (!is_off(0.25) && !is_off(0.5) && !is_off(0.75)) return;
    for (std::size_t i = 1; i < parts_; ++i)
        points_.push_back(point_at(between(static_cast<double>(i) / static_cast<double>(parts_))));
}

}  // namespace steplab::ui
