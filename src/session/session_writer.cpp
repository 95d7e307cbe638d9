#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/commit.hpp"
#include "io/scene_toml.hpp"
#include "io/starting_values_file.hpp"
#include "io/toml_text.hpp"
#include "session/event_words.hpp"
#include "session/session_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// With a point or an exponent, as -0 written as an integer would lose its sign.
std::string real(double value) {
    std::string text = number_text(value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string vector(Vec3 v) { return fmt::format("[{}, {}, {}]", real(v.x), real(v.y), real(v.z)); }

/// A file's text as it is, but for what has to be escaped: \r, too, as readers may take it for part of the line's end.
std::string whole_text(std::string_view text) {
    std::string result = "\"\"\"\n";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') result += '\\';
        if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(byte));
        } else {
            result += c;
        }
    }
    return result + "\"\"\"";
}

/// The keys of a run or an event with their values.
using Lines = std::vector<std::pair<std::string_view, std::string>>;

std::string joined(const Lines& lines, std::string_view separator) {
    std::string text;
    for (const auto& [key, value] : lines) text += fmt::format("{}{} = {}", text.empty() ? "" : separator, key, value);
    return text;
}

std::string parameters(const ParameterValues& values) {
    std::string text;
    for (const ParameterInfo& info : values.infos()) {
        const double value = values[info.name];
        const bool is_word = info.kind == ParameterInfo::Kind::choice;
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", toml_string(info.name),
                            is_word ? toml_string(format_value(info, value)) : real(value));
    }
    return text.empty() ? "{}" : "{ " + text + " }";
}

std::string text_of(std::size_t particle) { return std::to_string(particle); }
std::string text_of(const Alteration& one) {
    return fmt::format("{{ particle = {}{}{} }}", one.particle,
                       one.fixed ? fmt::format(", fixed = {}", *one.fixed) : "",
                       one.mass ? ", mass = " + real(*one.mass) : "");
}
template <class All>
std::string list_of(const All& all) {
    std::string text;
    for (const auto& one : all) text += (text.empty() ? "" : ", ") + text_of(one);
    return "[" + text + "]";
}

/// Writes runs, and notes the scenes and starting values that they share.
class WrittenRuns {
public:
    Lines lines(const RunDescription& run) {
        Lines lines;
        if (run.origin) {
            lines.emplace_back("scene", std::to_string(number_of(run.origin, scenes_)));
        } else {
            lines.emplace_back("model", toml_string(run.model));
        }
        lines.emplace_back("parameters", parameters(run.scene));
        lines.emplace_back("method", toml_string(run.method));
        if (!run.method_parameters.infos().empty())
            lines.emplace_back("method-parameters", parameters(run.method_parameters));
        lines.emplace_back("precision", toml_string(id(run.precision)));
        lines.emplace_back("dt", real(run.dt));
        if (run.start.from) lines.emplace_back("from", std::to_string(number_of(run.start.from, starts_)));
        if (run.start.reverse) lines.emplace_back("reverse", "true");
        if (!run.alterations.empty()) lines.emplace_back("alterations", list_of(run.alterations.all()));
        return lines;
    }
    std::string inline_table(const RunDescription& run) { return "{ " + joined(lines(run), ", ") + " }"; }

    std::string shared() const {
        std::string text;
        for (const SceneOrigin& scene : scenes_) {
            text += fmt::format("[[scenes]]\nname = {}\n", toml_string(scene->given));
            for (const SceneFile::Part& part : scene->parts)
                text += fmt::format("[[scenes.files]]\nname = {}\ncontent = {}\n", toml_string(part.name),
                                    whole_text(part.content));
            text += '\n';
        }
        for (const auto& start : starts_)
            text += fmt::format("[[starts]]\nname = {}\ncontent = {}\n\n", toml_string(start->given),
                                whole_text(csv_text(*start)));
        return text;
    }

private:
    static bool same(const SceneOrigin& a, const SceneOrigin& b) { return a == b && a->given == b->given; }
    static bool same(const std::shared_ptr<const StartingValues>& a, const std::shared_ptr<const StartingValues>& b) {
        return a == b || (*a == *b && a->given == b->given);
    }
    template <class Shared>
    static std::size_t number_of(const Shared& one, std::vector<Shared>& all) {
        const auto known = std::find_if(all.begin(), all.end(), [&](const Shared& other) { return same(one, other); });
        const auto number = static_cast<std::size_t>(known - all.begin());
        if (known == all.end()) all.push_back(one);
        return number;
    }

    std::vector<SceneOrigin> scenes_;
    std::vector<std::shared_ptr<const StartingValues>> starts_;
};

/// What an event has besides its word.
struct EventLines {
    WrittenRuns& runs;

    Lines operator()(const event::SetRate& speed) const {
        if (speed.rate.as_fast_as_possible) return {{"unlimited", "true"}};
        return {{"rate", real(speed.rate.seconds_per_second)}};
    }
    Lines operator()(const event::Step& step) const { return {{"steps", std::to_string(step.steps)}}; }
    Lines operator()(const event::Seek& seek) const { return {{"to", std::to_string(seek.step)}}; }
    Lines operator()(const event::SeekTime& seek) const { return {{"time", real(seek.time)}}; }
    Lines operator()(const event::Begin& begin) const { return {{"run", runs.inline_table(begin.description)}}; }
    Lines operator()(const event::Change& change) const {
        Lines lines{{"run", runs.inline_table(change.description)}};
        if (change.held) lines.emplace_back("held", "true");
        return lines;
    }
    Lines operator()(const event::Do& act) const { return std::visit(*this, act.act); }
    Lines operator()(const Pull& pull) const { return of_particles(pull, {{"position", vector(pull.position)}}); }
    Lines operator()(const Kick& kick) const { return of_particles(kick, {{"velocity", vector(kick.velocity)}}); }
    Lines operator()(const Tug& tug) const {
        Lines lines{{"position", vector(tug.position)}, {"rate", real(tug.rate)}};
        if (tug.goes_on) lines.emplace_back("goes-on", "true");
        return of_particles(tug, std::move(lines));
    }
    template <class OfParticles>
    static Lines of_particles(const OfParticles& act, Lines lines) {
        lines.emplace(lines.begin(), "particle", std::to_string(act.particle));
        if (!act.others.empty()) lines.emplace_back("others", list_of(act.others));
        return lines;
    }
    Lines operator()(const event::AddRun& add) const {
        Lines lines{{"run", runs.inline_table(add.description)}};
        if (add.opening) lines.emplace_back("opening", "true");
        return lines;
    }
    Lines operator()(const event::ChangeRun& change) const {
        return {{"number", std::to_string(change.run)}, {"run", runs.inline_table(change.description)}};
    }
    Lines operator()(const event::RemoveRun& remove) const { return {{"number", std::to_string(remove.run)}}; }
    Lines operator()(const event::Lead& lead) const { return {{"number", std::to_string(lead.run)}}; }
    Lines operator()(const event::Bookmark& mark) const { return {{"text", toml_string(mark.text)}}; }
    Lines operator()(const event::TakeBranch& take) const { return {{"number", std::to_string(take.branch)}}; }
    template <class Bare>
    Lines operator()(const Bare&) const {
        return {};
    }
};

std::string text_of(const RecordedEvent& entry, WrittenRuns& runs) {
    std::string text = fmt::format("\n[[events]]\nstep = {}\n", entry.step);
    if (entry.diverged) text += "diverged = true\n";
    if (entry.pause > 0) text += fmt::format("pause = {}\n", real(entry.pause));
    text += fmt::format("do = {}\n", toml_string(word_of(entry.event)));
    for (const auto& [key, value] : std::visit(EventLines{runs}, entry.event))
        text += fmt::format("{} = {}\n", key, value);
    if (!entry.hash.empty()) text += fmt::format("hash = {}\n", toml_string(entry.hash));
    return text;
}

std::string text_of(const RecordedEnd& end) {
    std::string hashes;
    for (const std::string& hash : end.hashes) hashes += (hashes.empty() ? "" : ", ") + toml_string(hash);
    return fmt::format("\n[end]\nstep = {}\n{}hashes = [{}]\n", end.step, end.diverged ? "diverged = true\n" : "",
                       hashes);
}

/// TOML is UTF-8; the files that a scene reads need not be.
void check_readable(const std::string& text) {
    try {
        const toml::table parsed = toml_table(text, "session");
    } catch (const toml::parse_error& error) {
        throw FileError(fmt::format("a session file cannot hold this scene or the files that it reads: {}",
                                    shown(error.description())));
    }
}

}  // namespace

std::string session_text(const Recording& recording) {
    WrittenRuns runs;
    std::string events = "[start]\n" + joined(runs.lines(recording.start), "\n") + '\n';
    for (const RecordedEvent& entry : recording.events) events += text_of(entry, runs);
    if (recording.end) events += text_of(*recording.end);
    std::string text =
        fmt::format("steplab-session = 2\nprogram = \"steplab {}\"\n\n{}{}", STEPLAB_VERSION, runs.shared(), events);
    check_readable(text);
    return text;
}

}  // namespace steplab
