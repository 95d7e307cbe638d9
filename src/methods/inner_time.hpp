#pragma once

#include "methods/compensated.hpp"

#include <type_traits>

namespace steplab {

/// Where the end of an adaptive method's last inner step lies, told from the frame that is to be shown, in two parts: it
/// keeps its digits however many frames and steps there were.
template <class T>
class InnerTime {
public:
    using Time = std::conditional_t<std::is_same_v<T, float>, double, T>;

    void next_frame(T dt) { add_compensated(ahead_, lost_, -static_cast<Time>(dt)); }
    void inner_step(T h) { add_compensated(ahead_, lost_, static_cast<Time>(h)); }
    /// How far the end of the last inner step is after the frame; below zero while another step is needed.
    Time ahead() const { return ahead_ + lost_; }

private:
    Time ahead_ = 0, lost_ = 0;
};

}  // namespace steplab
