#pragma once

#include "session/session_view.hpp"

#include <chrono>
#include <memory>

namespace steplab::ui {

/// Interpolates the picture of a playing run between its last two views, so that slow runs move smoothly: the picture
/// moves from one step to the next during the time until the following one is due. Readings and plots show whole steps
/// only.
class Glide {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// Takes a newer view of the session.
    void arrived(std::shared_ptr<const SessionView> view, Time now);

    /// The view to interpolate from; null while the newest view is shown as it is.
    std::shared_ptr<const SessionView> from(Time now) const { return gliding(now) ? from_ : nullptr; }
    /// Position between that view (0) and the newest one (1).
    double fraction(Time now) const;
    /// True while the picture changes without input.
    bool gliding(Time now) const { return fraction(now) < 1; }

private:
    std::shared_ptr<const SessionView> from_;
    std::shared_ptr<const SessionView> newest_;
    Time begin_{};
    double duration_ = 0;  ///< seconds; 0: no interpolation
};

}  // namespace steplab::ui
