#pragma once

#include <chrono>

namespace steplab {

/// Keeps what is done beside a run to a part of the time: after it took so long, it waits in proportion.
class Share {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = Time::duration;

    /// `part` of the time, > 0 and below 1.
    explicit Share(double part) : part_(part) {}

    bool due(Time now) const { return now >= next_; }
    void took(Time begin, Time end) {
        const std::chrono::duration<double> rest = (end - begin) * (1 / part_ - 1);
        next_ = end + std::chrono::duration_cast<Duration>(rest);
    }

private:
    double part_;
    Time next_{};
};

}  // namespace steplab
