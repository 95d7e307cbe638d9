#pragma once

#include "core/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// The radial distribution function g(r) of particles in a periodic box, averaged over frames: pairs at a distance r by
/// those that an ideal gas of the same density has there.
class RadialDistribution {
public:
    /// Distances up to half the shortest side of the box [m], the nearest image, in so many bins.
    RadialDistribution(Vec3 box, std::size_t bins);

    Vec3 box() const { return box_; }

    /// Takes a time proportional to the number of pairs. Throws Interrupted.
    void add(const std::vector<Vec3>& positions);

    std::size_t bins() const { return pairs_.size(); }
    /// The middle of a bin.
    double distance(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }
    double operator[](std::size_t bin) const;

private:
    Vec3 box_;
    double reach_, width_;
    std::vector<std::uint64_t> pairs_;
    double all_pairs_ = 0;  ///< of all frames
};

}  // namespace steplab
