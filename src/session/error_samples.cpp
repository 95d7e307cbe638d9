#include "session/error_samples.hpp"

#include "core/error.hpp"
#include "lab/study/distances.hpp"
#include "session/same_way.hpp"

#include <algorithm>

namespace steplab {

namespace {

/// For going back to where the run was changed.
constexpr std::size_t bytes_of_moments = std::size_t{8} << 20;

}  // namespace

ErrorSamples::ErrorSamples(const RunDescription& start)
    : line_(start, bytes_of_moments),
      motion_(start),
      changes_{{0, start}},
      rows_(first_spacing(line_.run().particles())) {}

void ErrorSamples::follow(std::span<const SegmentBegin> changes, std::uint64_t reached) {
    reached_ = reached;
    const auto other = first_difference(changes_, changes);
    if (!other) return;
    if (!begins_with(changes.front().description)) throw UsageError("this is another run");
    changes_.assign(changes.begin(), changes.end());
    line_.keep_changes(same_changes(line_.changes(), changes_));
    line_.turn_to(*other);
    line_.forget_ahead();
    const std::lock_guard lock(mutex_);
    rows_.cut(*other);
}

std::uint64_t ErrorSamples::next() const {
    return rows_.all().empty() ? 0 : rows_.all().back().step + rows_.to_next(rows_.all().back().step);
}

bool ErrorSamples::is_due() const { return next() <= reached_ && !line_.is_over(); }

/// With what was done on the way.
void ErrorSamples::go_to(std::uint64_t step) {
    line_.turn_to(step);
    for (std::size_t next = line_.changes().size(); next < changes_.size() && changes_[next].step <= step; ++next) {
        const SegmentBegin& change = changes_[next];
        line_.advance(change.step - std::min(change.step, line_.step()));
        change.act ? line_.act(*change.act) : line_.change(change.description, false);
    }
    line_.advance(step - std::min(step, line_.step()));
    line_.keep_moment();
}

void ErrorSamples::take() {
    const std::uint64_t step = next();
    go_to(step);
    if (line_.step() != step) return;
    motion_.follow(line_.past());
    const ReferenceMoment there = motion_.at(line_.time());
    const double error = largest_distance(there.state.displacement, line_.run().state().displacement);
    const std::lock_guard lock(mutex_);
    rows_.put({step, line_.time(), error, motion_.is_exact() ? 0 : there.error});
}

void ErrorSamples::put_into(ErrorSeries& series) const {
    const std::lock_guard lock(mutex_);
    rows_.put_into(series);
}

}  // namespace steplab
