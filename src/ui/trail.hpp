#pragma once

#include "core/vec3.hpp"
#include "render/style.hpp"
#include "session/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace steplab::ui {

/// Where the selected particle has been in this run, and those that were selected before it, the newest place last; the
/// oldest places are forgotten, and the first particles where there are too many.
class Trails {
public:
    static constexpr std::size_t most_particles = 8;

    /// Unless trails are `shown`, particles selected before are forgotten.
    void record(const RunView& view, bool shown);
    /// Null before one has moved.
    const std::shared_ptr<const render::Trails>& places() const { return places_; }

private:
    struct Trail {
        std::size_t particle = 0;
        std::deque<Vec3> places = {};
    };
    void select(std::size_t particle, bool shown);

    std::uint64_t run_ = 0, step_ = 0;
    std::vector<Trail> trails_;  ///< the selected particle last
    std::shared_ptr<const render::Trails> places_;
};

}  // namespace steplab::ui
