#pragma once

#include "core/entry.hpp"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace steplab {

/// What follows from values of parameters, of the last so many different ones, where that takes long to find and is
/// asked for often. While it is found, others wait.
template <class What, std::size_t most = 1>
class Known {
public:
    template <class Find>
    What of(const ParameterValues& values, const Find& find) {
        const std::lock_guard lock(mutex_);
        const auto found =
            std::find_if(all_.begin(), all_.end(), [&](const auto& known) { return known.first == values; });
        if (found != all_.end()) {
            std::rotate(all_.begin(), found, found + 1);
        } else {
            if (all_.size() == most) all_.pop_back();
            all_.insert(all_.begin(), {values, find()});
        }
        return all_.front().second;
    }

private:
    std::mutex mutex_;
    std::vector<std::pair<ParameterValues, What>> all_;  ///< the last one asked for first
};

/// For what takes little memory: of as many values as there are runs of one scene at the same time, and some before.
template <class What>
using KnownOfRuns = Known<What, 8>;

}  // namespace steplab
