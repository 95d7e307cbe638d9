#include "session/tug.hpp"

#include "session/session.hpp"

#include <utility>

namespace steplab {

namespace {

/// As it is done now: a tug acts for the time since the one before it of its hold, the first one for a step.
Act timed(Act act, const TimeLine& line) {
    auto* const tug = std::get_if<Tug>(&act);
    if (!tug) return act;
    const SegmentBegin& last = line.past().back();
    tug->goes_on = tug->goes_on && last.act && std::holds_alternative<Tug>(*last.act);
    tug->duration = tug->goes_on ? line.time() - last.time : line.run().dt();
    return act;
}

bool is_idle(const Act& act) {
    const auto* const tug = std::get_if<Tug>(&act);
    return tug && tug->duration == 0;
}

}  // namespace

bool continues(const SegmentBegin& before, const SegmentBegin& change) {
    if (!change.act) return change.held && !before.act;
    return before.act && continues(*change.act, *before.act);
}

std::size_t first_of_last(std::span<const SegmentBegin> changes) {
    std::size_t first = changes.size() - 1;
    while (first > 1 && continues(changes[first - 1], changes[first])) --first;
    return first;
}

void Session::act(const Act& asked) {
    if (plays_backwards()) stop();  // the run would go away from what is done
    const auto act = on_moving(timed(asked, line_), *run().shape());
    if (!act || is_idle(*act)) return;
    const std::size_t before = line_.past().size();
    keep(line_.act(*act));
    acted(before);
}

}  // namespace steplab
