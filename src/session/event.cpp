#include "session/event.hpp"

#include "core/error.hpp"

namespace steplab {

void check(const event::Loop& loop) {
    if (loop.steps && loop.steps->first >= loop.steps->last)
        throw UsageError("a loop ends at a later step than it begins");
}

bool overtakes(const Event& earlier, const Event& later) {
    if (earlier.index() != later.index()) return false;
    if (const auto* const act = std::get_if<event::Do>(&later)) {
        const Act& before = std::get<event::Do>(earlier).act;
        const Tug* const first = std::get_if<Tug>(&before);
        return overwrites(act->act, before) || (first && first->goes_on && continues(act->act, before));
    }
    if (const auto* const change = std::get_if<event::ChangeRun>(&later))
        return change->run == std::get<event::ChangeRun>(earlier).run;
    if (const auto* const change = std::get_if<event::Change>(&later))
        return change->held == std::get<event::Change>(earlier).held;
    return std::holds_alternative<event::Seek>(later) || std::holds_alternative<event::SeekTime>(later) ||
           std::holds_alternative<event::SetRate>(later) || std::holds_alternative<event::Track>(later) ||
           std::holds_alternative<event::AlsoTrack>(later) || std::holds_alternative<event::ShowEnsemble>(later) ||
           std::holds_alternative<event::ShowForces>(later) || std::holds_alternative<event::Magnify>(later) ||
           std::holds_alternative<event::ShowSamples>(later) || std::holds_alternative<event::ShowCosts>(later) ||
           std::holds_alternative<event::ShowErrors>(later) || std::holds_alternative<event::Play>(later) ||
           std::holds_alternative<event::Loop>(later);
}

}  // namespace steplab
