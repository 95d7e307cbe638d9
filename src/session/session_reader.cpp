#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/input_file.hpp"
#include "io/scene_file.hpp"
#include "io/starting_values_file.hpp"
#include "io/toml_text.hpp"
#include "session/event_words.hpp"
#include "session/session.hpp"
#include "session/session_file.hpp"
#include "session/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{1} << 30;
constexpr std::size_t most_listed = std::size_t{1} << 32;

Vec3 vector_of(const toml::node& node) {
    const auto elements = elements_of(node, "three numbers, [x, y, z]", 3, 3);
    return {number_of(*elements[0]), number_of(*elements[1]), number_of(*elements[2])};
}

std::string hash_of(const toml::node& node) {
    std::string text = text_of(node);
    if (text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos) return text;
    fail_at(node, "a hash must be 16 hexadecimal digits");
}

/// Calls `work`, whose refusals are problems of this place.
template <class Work>
auto placed(const toml::node& node, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        fail_at(node, error.what());
    }
}

void set_parameters(const toml::node& node, std::string_view of, ParameterValues& values) {
    std::vector<std::string_view> known;
    for (const ParameterInfo& info : values.infos()) known.push_back(info.name);
    for (const auto& [key, value] : table_of(node, "parameters")) {
        const std::string name(key.str());
        if (!values.contains(name)) fail_at(value, unknown_word("parameter", name, known, std::string(of)));
        placed(value, [&, &given = value] {
            if (given.is_string()) return values.set_text(name, text_of(given));
            values.set(name, number_of(given));
        });
    }
}

std::vector<Alteration> alterations_of(const toml::node& node) {
    const auto elements = elements_of(node, "tables, each of a particle", 0, most_listed);
    std::vector<Alteration> all;
    for (const toml::node* const element : elements) {
        Alteration one;
        const toml::table& table = table_of(*element, "an alteration");
        read_keys(table, "an alteration",
                  {{"particle", [&](const toml::node& given) { one.particle = count_of(given); }},
                   {"fixed", [&](const toml::node& given) { one.fixed = flag_of(given); }},
                   {"mass", [&](const toml::node& given) { one.mass = number_of(given); }}});
        needed(table, "an alteration", "particle");
        all.push_back(one);
    }
    return all;
}

/// A session is played forward in time.
double forward_dt_of(const toml::node& node) {
    const double dt = number_of(node);
    if (dt < 0) fail_at(node, "a session goes forward in time: dt must be > 0");
    return dt;
}

/// The runs of a file, with the scenes and starting values that they share.
class Runs {
public:
    explicit Runs(const toml::table& root) {
        each_table(root, "scenes", [this](const toml::table& table) { add_scene(table); });
        each_table(root, "starts", [this](const toml::table& table) { add_start(table); });
    }

    RunDescription run(const toml::node& node, std::string_view what) const {
        const toml::table& table = table_of(node, what);
        constexpr std::array<std::string_view, 10> keys{
            "model",     "scene", "parameters", "method",  "method-parameters",
            "precision", "dt",    "from",       "reverse", "alterations"};
        check_keys(table, what, keys);
        RunDescription run = of_scene(table, what);
        const toml::node& method = needed(table, what, "method");
        run = placed(method, [&] { return with_method(run, text_of(method)); });
        set_parameters(needed(table, what, "parameters"), run.model, run.scene);
        if (const auto* const values = table.get("method-parameters"))
            set_parameters(*values, run.method, run.method_parameters);
        run.precision = *parse_precision(word_of(needed(table, what, "precision"), "precision", {"float", "double"}));
        run.dt = forward_dt_of(needed(table, what, "dt"));
        if (const auto* const from = table.get("from")) run.start.from = chosen(*from, starts_, "starts");
        if (const auto* const reverse = table.get("reverse")) run.start.reverse = flag_of(*reverse);
        if (const auto* const alterations = table.get("alterations"))
            run = with_alterations(run, alterations_of(*alterations));
        placed(node, [&] { check_values(run); });
        return run;
    }

private:
    template <class Shared>
    static const Shared& chosen(const toml::node& node, const std::vector<Shared>& all, std::string_view name) {
        const std::uint64_t number = count_of(node);
        if (number < all.size()) return all[number];
        fail_at(node, fmt::format("the file has {} [[{}]], counted from 0", all.size(), name));
    }

    RunDescription of_scene(const toml::table& table, std::string_view what) const {
        const toml::node* const scene = table.get("scene");
        if (scene) return placed(*scene, [&] { return describe(chosen(*scene, scenes_, "scenes")); });
        const toml::node& model = needed(table, what, "model");
        return placed(model, [&] { return describe(text_of(model)); });
    }

    void add_scene(const toml::table& table) {
        constexpr std::array<std::string_view, 2> keys{"name", "files"}, file_keys{"name", "content"};
        check_keys(table, "[[scenes]]", keys);
        const std::string name = text_of(needed(table, "a scene", "name"));
        if (!table.contains("files")) return scenes_.push_back(shipped_scene(table, name));
        std::vector<SceneFile::Part> parts;
        each_table(table, "files", [&](const toml::table& file) {
            check_keys(file, "[[scenes.files]]", file_keys);
            parts.push_back({text_of(needed(file, "a file", "name")), text_of(needed(file, "a file", "content"))});
        });
        if (parts.empty()) fail_at(table, "a scene needs [[scenes.files]]");
        scenes_.push_back(placed(table, [&] { return scene_from(std::move(parts), name); }));
    }

    /// One without its text.
    static SceneOrigin shipped_scene(const toml::table& table, const std::string& name) {
        const std::vector<std::string> names = shipped_scenes();
        if (std::find(names.begin(), names.end(), name) == names.end())
            fail_at(table, fmt::format("'{}' is no scene that comes with the program: [[scenes.files]] must have it",
                                       shown(name)));
        return placed(table, [&] { return find_scene(name); });
    }

    void add_start(const toml::table& table) {
        constexpr std::array<std::string_view, 2> keys{"name", "content"};
        check_keys(table, "[[starts]]", keys);
        const std::string name = text_of(needed(table, "a start", "name"));
        const auto content = std::make_shared<const std::string>(text_of(needed(table, "a start", "content")));
        StartingValues values = placed(table, [&] { return starting_values(TextInput(name, content), {}); });
        values.given = name;
        starts_.push_back(std::make_shared<const StartingValues>(std::move(values)));
    }

    std::vector<SceneOrigin> scenes_;
    std::vector<std::shared_ptr<const StartingValues>> starts_;
};

/// An event of a file: its table, and the runs that it may name.
struct Given {
    const toml::table& table;
    std::string_view word;
    const Runs& runs;

    const toml::node& operator[](std::string_view key) const { return needed(table, fmt::format("'{}'", word), key); }
    RunDescription run() const { return runs.run((*this)["run"], "the run of an event"); }
    std::size_t number() const { return count_of((*this)["number"]); }
    bool flag(std::string_view key) const {
        const toml::node* const node = table.get(key);
        return node && flag_of(*node);
    }
    double rate() const {
        const toml::node& node = (*this)["rate"];
        const double rate = number_of(node);
        if (!(rate > 0)) fail_at(node, "a rate must be > 0");
        return rate;
    }
    Rate speed() const {
        if (flag("unlimited")) return {.as_fast_as_possible = true};
        return {.seconds_per_second = rate()};
    }
    /// Those to which the same is done.
    ParticleList others() const {
        const toml::node* const node = table.get("others");
        if (!node) return {};
        std::vector<std::size_t> all;
        for (const toml::node* const one : elements_of(*node, "numbers of particles", 0, most_listed))
            all.push_back(count_of(*one));
        return ParticleList(std::move(all));
    }
};

double pause_of(const toml::node& node) {
    const double pause = number_of(node);
    if (!(pause >= 0)) fail_at(node, "a pause must be >= 0 s");
    return pause;
}

/// A word, the keys that go with it, and the event that they make.
struct EventKind {
    std::string_view word;
    std::vector<std::string_view> keys;
    Event (*read)(const Given&);
};

const std::vector<EventKind>& event_kinds() {
    static const std::vector<EventKind> kinds{
        {"play", {}, [](const Given&) -> Event { return event::Play{true}; }},
        {"pause", {}, [](const Given&) -> Event { return event::Play{false}; }},
        {"speed", {"rate", "unlimited"}, [](const Given& given) -> Event { return event::SetRate{given.speed()}; }},
        {"step", {"steps"}, [](const Given& given) -> Event { return event::Step{integer_of(given["steps"])}; }},
        {"seek", {"to"}, [](const Given& given) -> Event { return event::Seek{count_of(given["to"])}; }},
        {"seek-time", {"time"}, [](const Given& given) -> Event { return event::SeekTime{number_of(given["time"])}; }},
        {"restart", {}, [](const Given&) -> Event { return event::Restart{}; }},
        {"begin", {"run"}, [](const Given& given) -> Event { return event::Begin{given.run()}; }},
        {"change",
         {"run", "held"},
         [](const Given& given) -> Event {
             return event::Change{given.run(), given.flag("held")};
         }},
        {"pull",
         {"particle", "position", "others"},
         [](const Given& given) -> Event {
             return event::Do{Pull{count_of(given["particle"]), vector_of(given["position"]), given.others()}};
         }},
        {"kick",
         {"particle", "velocity", "others"},
         [](const Given& given) -> Event {
             return event::Do{Kick{count_of(given["particle"]), vector_of(given["velocity"]), given.others()}};
         }},
        {"tug",
         {"particle", "position", "rate", "goes-on", "others"},
         [](const Given& given) -> Event {
             return event::Do{Tug{count_of(given["particle"]), vector_of(given["position"]), given.rate(),
                                  given.flag("goes-on"), given.others()}};
         }},
        {"turn-round", {}, [](const Given&) -> Event { return event::Do{TurnRound{}}; }},
        {"undo", {}, [](const Given&) -> Event { return event::Undo{}; }},
        {"redo", {}, [](const Given&) -> Event { return event::Redo{}; }},
        {"add-run",
         {"run", "opening"},
         [](const Given& given) -> Event {
             return event::AddRun{given.run(), given.flag("opening")};
         }},
        {"change-run",
         {"number", "run"},
         [](const Given& given) -> Event {
             return event::ChangeRun{given.number(), given.run()};
         }},
        {"equal-cost", {}, [](const Given&) -> Event { return event::EqualCost{true}; }},
        {"own-cost", {}, [](const Given&) -> Event { return event::EqualCost{false}; }},
        {"remove-run", {"number"}, [](const Given& given) -> Event { return event::RemoveRun{given.number()}; }},
        {"lead", {"number"}, [](const Given& given) -> Event { return event::Lead{given.number()}; }},
        {"bookmark", {"text"}, [](const Given& given) -> Event { return event::Bookmark{text_of(given["text"])}; }},
        {"take-branch", {"number"}, [](const Given& given) -> Event { return event::TakeBranch{given.number()}; }}};
    return kinds;
}

RecordedEvent event_of(const toml::table& table, const Runs& runs) {
    const auto& kinds = event_kinds();
    std::vector<std::string_view> words(kinds.size());
    std::transform(kinds.begin(), kinds.end(), words.begin(), [](const EventKind& kind) { return kind.word; });
    const std::string word = word_of(needed(table, "[[events]]", "do"), "event", words);
    const auto kind = std::find(words.begin(), words.end(), word) - words.begin();
    const EventKind& found = kinds[static_cast<std::size_t>(kind)];
    std::vector<std::string_view> keys{"step", "diverged", "do", "hash", "pause"};
    keys.insert(keys.end(), found.keys.begin(), found.keys.end());
    check_keys(table, fmt::format("'{}'", word), keys);
    RecordedEvent entry{found.read({table, word, runs}), count_of(needed(table, "[[events]]", "step"))};
    if (const auto* const diverged = table.get("diverged")) entry.diverged = flag_of(*diverged);
    if (const auto* const hash = table.get("hash")) entry.hash = hash_of(*hash);
    if (const auto* const pause = table.get("pause")) entry.pause = pause_of(*pause);
    return entry;
}

RecordedEnd end_of(const toml::node& node) {
    const toml::table& table = table_of(node, "[end]");
    RecordedEnd end;
    read_keys(table, "[end]",
              {{"step", [&](const toml::node& given) { end.step = count_of(given); }},
               {"diverged", [&](const toml::node& given) { end.diverged = flag_of(given); }},
               {"hashes", [&](const toml::node& given) {
                    const auto hashes = elements_of(given, "the hash of each run", 0, Session::most_runs);
                    for (const toml::node* const hash : hashes) end.hashes.push_back(hash_of(*hash));
                }}});
    needed(table, "[end]", "step");
    return end;
}

Recording recording_of(const toml::table& root) {
    const toml::node* const version = root.get("steplab-session");
    if (!version) throw SceneProblem({1, 1}, "a session file begins with its version: steplab-session = 2");
    if (const auto number = integer_of(*version); number != 1 && number != 2)
        fail_at(*version, "this program reads versions 1 and 2: steplab-session = 2");
    constexpr std::array<std::string_view, 7> keys{"steplab-session", "program", "scenes", "starts",
                                                   "start",           "events",  "end"};
    check_keys(root, "a session file", keys);
    const Runs runs(root);
    const toml::node& start = needed(root, "a session file", "start");
    Recording recording{.start = runs.run(start, "[start]")};
    placed(start, [&] { check(recording.start); });
    each_table(root, "events", [&](const toml::table& table) { recording.events.push_back(event_of(table, runs)); });
    if (const toml::node* const end = root.get("end")) recording.end = end_of(*end);
    return recording;
}

}  // namespace

Recording parse_session(const std::string& text, const std::string& name) {
    return in_file(name, [&] { return recording_of(toml_table(text, name)); });
}

Recording read_session_file(const std::string& path) {
    const InputFile file(path);
    if (file.size() > largest_file) throw FileError(fmt::format("'{}': a session file has at most 1 GB", shown(path)));
    return parse_session(file.read(0, file.size()), path);
}

}  // namespace steplab
