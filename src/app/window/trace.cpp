#include "app/window/trace.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/output_file.hpp"
#include "render/framing.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <vector>

namespace steplab {

void Trace::Close::operator()(std::FILE* file) const {
    if (file != stdout) std::fclose(file);
}

Trace::Trace(const std::string& file) : name_(file == "-" ? "standard output" : fmt::format("'{}'", shown(file))) {
    if (file.empty()) return;
    out_.reset(file == "-" ? stdout : std::fopen(file.c_str(), "w"));
    if (!out_) fail();
}

void Trace::fail() const {
    if (errno == EPIPE) throw ReaderGone();
    throw FileError(fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
}

void Trace::report(std::string_view name, const std::string& value) {
    if (!out_) return;
    const auto last = reported_.find(name);
    if (last != reported_.end() && last->second == value) return;
    reported_.insert_or_assign(std::string(name), value);
    const std::string line = fmt::format("{} {}\n", name, shown(value, value.size()));
    if (std::fputs(line.c_str(), out_.get()) < 0 || std::fflush(out_.get()) != 0) fail();
}

void Trace::report(const RunView& view) {
    const RunDescription& run = view.description;
    report("model", run.model);
    report("method", run.method);
    report("precision", std::string(id(run.precision)));
    report("dt", number_text(run.dt));
    report("command", command_line(run));
    report("run", std::to_string(view.run));
    report("step", std::to_string(view.frame.step));
    report("playing", view.playing ? "true" : "false");
    report("rate", view.rate.as_fast_as_possible ? "fastest" : number_text(view.rate.seconds_per_second));
    report("tracked", view.tracked ? std::to_string(view.tracked->particle) : "none");
    report("diverged", view.divergence ? std::to_string(view.divergence->step) : "no");
    report("ensemble", view.ensemble.runs == 0       ? "none"
                       : view.frame.ensemble.empty() ? "being computed"
                                                     : number_text(view.ensemble_spread.largest));
    report("altered", std::to_string(run.alterations.all().size()));
    report("error", view.error.empty() ? "none" : view.error);
}

void Trace::report(const SessionView& session) {
    report(session.leading);
    const auto text = [](const RunView& run) {
        const RunDescription& of = run.description;
        return fmt::format("{} {} {}", of.method, id(of.precision), number_text(of.dt));
    };
    std::string runs = text(session.leading);
    for (const RunView& run : session.followers) runs += ", " + text(run);
    report("runs", runs);
    report("compared", session.errors ? std::to_string(session.errors->runs.size()) : "none");
    report("costs", !session.costs ? "none" : session.costs->complete ? "complete" : "being measured");
    report("reached", std::to_string(session.line.reached));
    report("changes", std::to_string(session.line.changes.size()));
    report("branches", std::to_string(session.line.branches.size()));
    report("loop", session.line.loop ? "true" : "false");
    const auto& playback = session.playback;
    report("playback", playback ? fmt::format("{} {}", playback->frame, playback->frames) : "none");
    report("bookmarks", std::to_string(session.line.bookmarks.size()));
}

void Trace::report(const render::Camera& camera) { report("camera", render::view_text(camera)); }

void Trace::report(const ui::WidgetMap& widgets, bool last_frame) {
    if (!out_) return;
    std::vector<std::string> gone;
    for (const auto& [line, value] : reported_) {
        if (!line.starts_with("widget ") || value == "gone") continue;
        const std::string widget = line.substr(7);
        if (!widgets.contains(widget) && (last_frame || !before_.contains(widget))) gone.push_back(line);
    }
    for (const std::string& line : gone) report(line, "gone");
    for (const auto& [name, place] : widgets) {
        const auto before = before_.find(name);
        if (!last_frame && (before == before_.end() || before->second != place)) continue;
        report("widget " + name,
               fmt::format("{:.0f} {:.0f} {:.0f} {:.0f}", place.left, place.top, place.right, place.bottom));
    }
    before_ = widgets;
}

}  // namespace steplab
