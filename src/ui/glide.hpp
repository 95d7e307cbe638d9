#pragma once

#include "sim/run/run_view.hpp"

#include <chrono>
#include <memory>

namespace steplab::ui {

/// Where between its last two moments a playing run is shown, so that ten steps a second do not look like ten: the
/// picture glides from one step to the next in the time until the one after is due. Read-outs and plots show steps
/// alone.
class Glide {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// A newer view of the run is there.
    void arrived(std::shared_ptr<const RunView> view, Time now);

    /// The moment glided from; null while the newest view is shown as it is.
    std::shared_ptr<const RunView> from(Time now) const { return gliding(now) ? from_ : nullptr; }
    /// How far from there to the newest view, 0 .. 1.
    double fraction(Time now) const;
    /// True while the picture changes by itself.
    bool gliding(Time now) const { return fraction(now) < 1; }

private:
    std::shared_ptr<const RunView> from_;
    std::shared_ptr<const RunView> newest_;
    Time begin_{};
    double duration_ = 0;  ///< seconds; 0: nothing to glide over
};

}  // namespace steplab::ui
