#include "session/event_words.hpp"

namespace steplab {

namespace {

struct ActWord {
    std::string_view operator()(const Pull&) const { return "pull"; }
    std::string_view operator()(const Kick&) const { return "kick"; }
    std::string_view operator()(const Tug&) const { return "tug"; }
    std::string_view operator()(const TurnRound&) const { return "turn-round"; }
};

struct EventWord {
    std::string_view operator()(const event::Play& play) const { return play.on ? "play" : "pause"; }
    std::string_view operator()(const event::SetRate&) const { return "speed"; }
    std::string_view operator()(const event::Step&) const { return "step"; }
    std::string_view operator()(const event::Seek&) const { return "seek"; }
    std::string_view operator()(const event::SeekTime&) const { return "seek-time"; }
    std::string_view operator()(const event::Restart&) const { return "restart"; }
    std::string_view operator()(const event::Begin&) const { return "begin"; }
    std::string_view operator()(const event::Change&) const { return "change"; }
    std::string_view operator()(const event::Do& act) const { return std::visit(ActWord{}, act.act); }
    std::string_view operator()(const event::Undo&) const { return "undo"; }
    std::string_view operator()(const event::Redo&) const { return "redo"; }
    std::string_view operator()(const event::AddRun&) const { return "add-run"; }
    std::string_view operator()(const event::ChangeRun&) const { return "change-run"; }
    std::string_view operator()(const event::EqualCost& cost) const { return cost.on ? "equal-cost" : "own-cost"; }
    std::string_view operator()(const event::RemoveRun&) const { return "remove-run"; }
    std::string_view operator()(const event::Lead&) const { return "lead"; }
    std::string_view operator()(const event::Bookmark&) const { return "bookmark"; }
    std::string_view operator()(const event::TakeBranch&) const { return "take-branch"; }
    template <class Shown>
    std::string_view operator()(const Shown&) const {
        return "show";
    }
};

}  // namespace

std::string_view word_of(const Event& event) { return std::visit(EventWord{}, event); }

}  // namespace steplab
