#include "io/scene_file.hpp"

#include "core/error.hpp"
#include "core/known.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_problems.hpp"
#include "io/scene_reader.hpp"
#include "io/shared_files.hpp"
#include "io/toml_text.hpp"
#include "models/scene/planner.hpp"
#include "models/scene/scene_facts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/known_motion.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace steplab {

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20;
constexpr std::size_t most_values = 4'000'000;  // some 300 MB, and a second
/// What --run, --set and --spread of a run mean by themselves.
constexpr std::array<std::string_view, 3> names_of_runs{"method", "precision", "dt"};

/// What a run takes for each particle by the method that takes least: which one is to run is not known while a file is
/// read.
double least_bytes_per_particle() {
    double least = infinity;
    for (const Method& method : methods()) {
        RunDescription run = with_method({}, method.info.id);
        run.precision = Precision::float_;
        least = std::min(least, bytes_per_particle(run));
    }
    return least;
}

/// A parsed file; the scene for given values of its parameters is read from it once more.
class Document {
public:
    Document(const std::string& text, const std::string& name, ParticleFiles files)
        : root_(toml_table(text, name, most_values)), files_(std::move(files)), parameters_(root_, problems_) {
        const ParameterValues values(parameters_.infos());
        SceneNumbers numbers(parameters_, values);
        texts_ = read_texts(root_, numbers, problems_);
        const SceneStart start = read_scene(root_, numbers, files_, how(true, false), problems_).start;
        problems_.report();
        note_uses(numbers);
        check_names();
        opened_with_ = ParameterValues(parameters_.infos());
        if (start.mode > 0) plan(opened_with_);
    }
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    Scene scene(const ParameterValues& values) const { return read(values, how(true, values == opened_with_)); }
    double particles(const ParameterValues& values) const {
        return static_cast<double>(read(values, how(false, false)).count());
    }
    /// Why a run in float would be one of other numbers.
    std::optional<std::string> lost_in_float(const ParameterValues& values, const std::string& name) const {
        return lost_in_float_.of(values, [&]() -> std::optional<std::string> {
            SceneNumbers numbers(parameters_, values);
            SceneProblems problems;
            read_scene(root_, numbers, files_, how(false, false), problems);
            try {
                problems.report();
                numbers.lost_in_float().report();
            } catch (const SceneProblem& problem) {
                return place_text(name, problem.place()) + problem.what();
            }
            return std::nullopt;
        });
    }
    /// How it is stepped from the start that the file says. Modes take long to find: they are kept.
    Plan plan(const ParameterValues& values) const {
        const Scene scene = this->scene(values);
        const SceneStart& start = scene.start;
        if (start == SceneStart()) return planned(scene);
        const auto find = [&] {
            Plan plan = planned(scene);
            try {
                return started(std::move(plan), shape_of(scene), start);
            } catch (const UsageError& error) {
                const toml::node* const mode = root_["start"]["mode"].node();
                fail_at(mode ? *mode : *root_.get("start"), error.what());
            }
        };
        return start.mode > 0 ? plans_.of(values, find) : find();
    }
    /// The files that it reads.
    const std::vector<SceneFile::Part>& parts() const { return files_.parts(); }
    const SceneTexts& texts() const { return texts_; }
    std::span<const ParameterInfo> infos() const { return parameters_.infos(); }

private:
    SceneReading how(bool checks, bool starts_are_known) const {
        return {bytes_per_particle_, memory_, checks, starts_are_known};
    }
    Scene read(const ParameterValues& values, const SceneReading& how) const {
        SceneNumbers numbers(parameters_, values);
        SceneProblems problems;
        Scene scene = read_scene(root_, numbers, files_, how, problems);
        problems.report();
        return scene;
    }
    void note_uses(const SceneNumbers& numbers) {
        for (const auto& [name, use] : numbers.used()) {
            if (use == SceneNumbers::Use::start) parameters_.on_change(name, OnChange::restarts);
        }
        for (const auto& [name, least] : numbers.counting()) parameters_.counts(name, least);
        const SceneParameters::Entry* unused = nullptr;
        std::string_view unused_name;
        for (const auto& [name, entry] : parameters_.entries()) {
            const bool first = !unused || entry.place->source().begin < unused->place->source().begin;
            if (!numbers.used().contains(name) && first) unused = &entry, unused_name = name;
        }
        if (!unused) return;
        check_values();
        fail_at(*unused->place, fmt::format("nothing uses the parameter '{}'", shown(unused_name)));
    }

    /// Of all parameters, whether something uses them or not.
    void check_values() {
        const ParameterValues values(parameters_.infos());
        SceneNumbers numbers(parameters_, values);
        for (const auto& one : parameters_.entries())
            problems_.attempt([&] { numbers.parameter(one.first, *one.second.place, SceneNumbers::Use::force); });
        problems_.report();
    }

    /// --set, --run and --spread have to know which is meant.
    void check_names() const {
        for (const std::string_view name : names_of_runs) {
            const auto same = parameters_.entries().find(name);
            if (same == parameters_.entries().end()) continue;
            fail_at(*same->second.place,
                    fmt::format("every run has a '{}' of its own; give the parameter another name", name));
        }
        if (texts_.defaults.method.empty()) return;
        const MethodInfo& info = method(texts_.defaults.method).info;
        for (const ParameterInfo& known : info.parameters) {
            const auto same = parameters_.entries().find(known.name);
            if (same == parameters_.entries().end()) continue;
            fail_at(*same->second.place,
                    fmt::format("'{}' is a parameter of the method {} too; give it another name", known.name, info.id));
        }
    }

    SceneProblems problems_;
    toml::table root_;
    mutable ParticleFiles files_;  // all of them are read when the document is made
    mutable Known<Plan> plans_;
    mutable KnownOfRuns<std::optional<std::string>> lost_in_float_;
    SceneParameters parameters_;
    SceneTexts texts_;
    ParameterValues opened_with_;  ///< as the file has them
    double bytes_per_particle_ = least_bytes_per_particle(), memory_ = available_memory();
};

/// Problems that only some values of the parameters have are those of the command line or of a slider.
template <class Work>
auto with_place(const std::string& name, const Work& work) {
    try {
        return work();
    } catch (const SceneProblem& problem) {
        throw UsageError(place_text(name, problem.place()) + problem.what());
    }
}

Model model_of(const std::shared_ptr<const Document>& document, const std::string& name) {
    const auto scene = [document, name](const ParameterValues& values) {
        return with_place(name, [&] { return document->scene(values); });
    };
    const SceneDefaults& defaults = document->texts().defaults;
    Model model;
    model.info = {.id = "scene",
                  .name = document->texts().title,
                  .what = document->texts().teaches,
                  .parameters = document->infos()};
    model.topic = document->texts().topic;
    if (!defaults.method.empty()) model.opening.method = defaults.method;
    if (defaults.dt) model.opening.dt = *defaults.dt;
    if (!defaults.precision.empty()) model.opening.precision = *parse_precision(defaults.precision);
    model.opening.until = defaults.until;
    model.particles = [document, name](const ParameterValues& values) {
        return with_place(name, [&] { return document->particles(values); });
    };
    model.lost_in_float = [document, name](const ParameterValues& values) {
        return document->lost_in_float(values, name);
    };
    model.facts = [scene, known = std::make_shared<KnownOfRuns<SceneFacts>>()](const ParameterValues& values) {
        return known->of(values, [&]() -> SceneFacts {
            try {
                return facts_of(scene(values));
            } catch (const UsageError&) {
                return {};  // check() says what is wrong
            }
        });
    };
    model.scene = scene;
    model.plan = [document, name](const ParameterValues& values) {
        return with_place(name, [&] { return document->plan(values); });
    };
    model.shape = [scene](const ParameterValues& values) { return shape_of(scene(values)); };
    model.omega_max = [model_plan = model.plan, shape = model.shape,
                       known = std::make_shared<KnownOfRuns<std::optional<double>>>()](const ParameterValues& values) {
        return known->of(values, [&]() -> std::optional<double> {
            const auto frequency = known_frequency(model_plan(values), shape(values));
            return frequency ? std::optional(frequency->omega) : std::nullopt;
        });
    };
    model.exact = [model_plan = model.plan](const ParameterValues& values) { return known_motion(model_plan(values)); };
    return model;
}

std::string content_of(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw FileError(fmt::format("{}: there is no such file", shown(path)));
    if (!std::filesystem::is_regular_file(status)) throw FileError(fmt::format("{}: it is not a file", shown(path)));
    if (std::filesystem::file_size(path, error) > largest_file)
        throw FileError(fmt::format("{}: a scene file has at most 64 MB", shown(path)));
    std::ifstream file(path, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(file)), {});
    if (!file) throw FileError(fmt::format("{}: it cannot be read", shown(path)));
    return content;
}

SceneOrigin origin_of(std::string text, const std::string& name, ParticleFiles files) {
    auto document = in_file(name, [&] { return std::make_shared<const Document>(text, name, std::move(files)); });
    auto file = std::make_shared<SceneFile>();
    file->parts.push_back({.name = "", .content = std::move(text)});
    file->parts.insert(file->parts.end(), document->parts().begin(), document->parts().end());
    file->given = name;
    file->defaults = document->texts().defaults;
    file->model = std::make_shared<const Model>(in_file(name, [&] { return model_of(document, name); }));
    return SceneOrigin(std::move(file));
}

SceneOrigin origin_of_file(const std::filesystem::path& path, const std::string& name) {
    return origin_of(content_of(path), name, ParticleFiles::in_folder(path.parent_path()));
}

}  // namespace

SceneOrigin scene_from(std::vector<SceneFile::Part> parts, const std::string& name) {
    std::string text = parts.front().content;
    parts.erase(parts.begin());
    return origin_of(std::move(text), name, ParticleFiles::carried(std::move(parts)));
}

std::vector<std::string> shipped_scenes() { return shared_names("scenes", ".toml"); }

std::filesystem::path scene_path(const std::string& name) {
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
    return is_file ? std::filesystem::path(name) : shared_file("scenes", name + ".toml");
}

SceneOrigin find_scene(const std::string& name) {
    const std::filesystem::path path = scene_path(name);
    if (!path.empty()) return origin_of_file(path, name);
    const std::vector<std::string> names = shipped_scenes();
    throw UsageError(unknown_word("scene", name, std::vector<std::string_view>(names.begin(), names.end())));
}

SceneOrigin read_scene_file(const std::string& path) { return origin_of_file(path, path); }

}  // namespace steplab
