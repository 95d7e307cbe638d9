#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// A long sequence of which neighbours mostly belong together, as runs: the roles "one fixed, then nine moving", the
/// particles "four from number 3, then one from number 9". Its memory is that of its runs.
template <class Value>
class Runs {
public:
    struct Run {
        Value value;
        std::uint64_t count;
    };

    /// `count` more, at least one.
    void add(Value value, std::uint64_t count) {
        ends_.push_back(size() + count);
        runs_.push_back({value, count});
    }
    std::uint64_t size() const { return ends_.empty() ? 0 : ends_.back(); }
    const std::vector<Run>& runs() const { return runs_; }

    /// Calls visit(value, offset within its run) for `count` elements from `first` on, which are there.
    template <class Visit>
    void each(std::uint64_t first, std::uint64_t count, const Visit& visit) const {
        const auto after = std::upper_bound(ends_.begin(), ends_.end(), first);
        auto run = static_cast<std::size_t>(after - ends_.begin());
        for (std::uint64_t at = first; at < first + count; ++at) {
            if (at == ends_[run]) ++run;
            visit(runs_[run].value, at - (ends_[run] - runs_[run].count));
        }
    }

private:
    std::vector<Run> runs_;
    std::vector<std::uint64_t> ends_;  ///< of each run, as indices of elements
};

}  // namespace steplab
