#pragma once

#include "core/vec3.hpp"
#include "sim/run/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace steplab::ui {

/// Where the selected particle has been in this run, the newest place last; the oldest are forgotten.
class Trail {
public:
    void record(const RunView& view);
    /// Null before it has moved.
    const std::shared_ptr<const std::vector<Vec3>>& places() const { return places_; }

private:
    std::optional<std::size_t> particle_;
    std::uint64_t run_ = 0, step_ = 0;
    std::deque<Vec3> kept_;
    std::shared_ptr<const std::vector<Vec3>> places_;
};

}  // namespace steplab::ui
