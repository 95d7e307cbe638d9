// A choice of the person that something else stands in for, as long as a lesson is open.
#pragma once

#include <optional>
#include <utility>

namespace steplab::ui {

/// Keeps a choice while another value is in its place, and gives it back unless the person has chosen since.
template <class T>
class Replaced {
public:
    /// `now` has been put in place of `before`.
    void put(const T& before, const T& now) {
        if (!pair_ || !(pair_->second == before)) pair_.emplace(before, now);
        pair_->second = now;
    }
    /// What the person chose, if `shown` is what was put in its place.
    const T& own(const T& shown) const { return pair_ && pair_->second == shown ? pair_->first : shown; }
    void forget() { pair_.reset(); }

private:
    std::optional<std::pair<T, T>> pair_;
};

}  // namespace steplab::ui
