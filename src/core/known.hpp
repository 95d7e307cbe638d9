#pragma once

#include "core/entry.hpp"

#include <mutex>
#include <optional>
#include <utility>

namespace steplab {

/// The last of what follows from values of parameters, where that takes long to find and is asked for often.
template <class What>
class Known {
public:
    template <class Find>
    What of(const ParameterValues& values, const Find& find) {
        const std::lock_guard lock(mutex_);
        if (!last_ || !(last_->first == values)) last_.emplace(values, find());
        return last_->second;
    }

private:
    std::mutex mutex_;
    std::optional<std::pair<ParameterValues, What>> last_;
};

}  // namespace steplab
