#pragma once

#include <chrono>

namespace steplab {

/// Keeps what is done beside a run to a part of the time: after it took so long, it waits in proportion, but not
/// longer than something may.
class Share {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = Time::duration;

    /// `part` of the time, > 0 and below 1; `longest` wait.
    explicit Share(double part, Duration longest = Duration::max()) : part_(part), longest_(longest) {}

    bool due(Time now) const { return now >= next_; }
    void took(Time begin, Time end) {
        const std::chrono::duration<double> rest = (end - begin) * (1 / part_ - 1);
        next_ = end + (rest < longest_ ? std::chrono::duration_cast<Duration>(rest) : longest_);
    }

private:
    double part_;
    Duration longest_;
    Time next_{};
};

}  // namespace steplab
