#include "render/motion.hpp"

namespace steplab::render {
namespace {

void glide_ensemble(const Frame& from, const Frame& to, double fraction, Frame& out) {
    const std::size_t count = to.positions.size();
    const bool there_before = from.ensemble.size() == to.ensemble.size();
    out.ensemble.resize(to.ensemble.size());
    for (std::size_t i = 0; i < to.ensemble.size(); ++i) {
        const Vec3 later = to.ensemble[i] - to.positions[i % count];
        const Vec3 earlier = there_before ? from.ensemble[i] - from.positions[i % count] : later;
        out.ensemble[i] = out.positions[i % count] + ((1 - fraction) * earlier + fraction * later);
    }
}

}  // namespace

void between(const Frame& from, const Frame& to, double fraction, Frame& out) {
    const double s = fraction, r = 1 - fraction, duration = to.time - from.time;
    const double to_position = s * s * (3 - 2 * s), from_position = r * r * (3 - 2 * r);
    const double from_velocity = duration * s * r * r, to_velocity = -duration * s * s * r;
    out.step = to.step;
    out.time = from.time + fraction * duration;
    out.precision = to.precision;
    out.shape = to.shape;
    out.velocities = to.velocities;
    out.forces = to.forces;
    out.oscillation = to.oscillation;
    out.values = to.values;
    out.cell = to.cell;
    out.magnified = to.magnified;
    out.positions.resize(to.positions.size());
    for (std::size_t i = 0; i < to.positions.size(); ++i) {
        out.positions[i] = from_position * from.positions[i] + to_position * to.positions[i] +
                           (from_velocity * from.velocities[i] + to_velocity * to.velocities[i]);
    }
    glide_ensemble(from, to, fraction, out);
}

}  // namespace steplab::render
