#include "sim/run/radial_distribution.hpp"

#include "core/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplab {

RadialDistribution::RadialDistribution(Vec3 box, std::size_t bins)
    : box_(box),
      reach_(std::min({box.x, box.y, box.z}) / 2),
      width_(reach_ / static_cast<double>(bins)),
      pairs_(bins) {}

void RadialDistribution::add(const std::vector<Vec3>& positions) {
    const auto nearest = [](double d, double side) { return d - side * std::nearbyint(d / side); };
    for (std::size_t i = 0; i < positions.size(); ++i) {
        check_interruption();
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 d = positions[j] - positions[i];
            const double distance = length(Vec3{nearest(d.x, box_.x), nearest(d.y, box_.y), nearest(d.z, box_.z)});
            if (distance < reach_) ++pairs_[std::min(bins() - 1, static_cast<std::size_t>(distance / width_))];
        }
    }
    const double count = static_cast<double>(positions.size());
    all_pairs_ += count * (count - 1) / 2;
}

double RadialDistribution::operator[](std::size_t bin) const {
    const double inner = static_cast<double>(bin) * width_, outer = inner + width_;
    const double shell = 4 * std::numbers::pi / 3 * (outer * outer * outer - inner * inner * inner);
    const double ideal = all_pairs_ * shell / (box_.x * box_.y * box_.z);
    return ideal > 0 ? static_cast<double>(pairs_[bin]) / ideal : 0;
}

}  // namespace steplab
