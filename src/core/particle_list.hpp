#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

/// Numbers of particles, ascending, each once. Copies share one list: what is done to many of them is done often.
class ParticleList {
public:
    ParticleList() = default;
    explicit ParticleList(std::vector<std::size_t> particles) {
        std::sort(particles.begin(), particles.end());
        particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
        if (!particles.empty()) particles_ = std::make_shared<const std::vector<std::size_t>>(std::move(particles));
    }

    bool empty() const { return !particles_; }
    std::size_t size() const { return particles_ ? particles_->size() : 0; }
    const std::size_t* begin() const { return particles_ ? particles_->data() : nullptr; }
    const std::size_t* end() const { return begin() + size(); }
    bool contains(std::size_t particle) const { return std::binary_search(begin(), end(), particle); }
    friend bool operator==(const ParticleList& a, const ParticleList& b) {
        return a.particles_ == b.particles_ || std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    std::shared_ptr<const std::vector<std::size_t>> particles_;  ///< null for none
};

}  // namespace steplab
