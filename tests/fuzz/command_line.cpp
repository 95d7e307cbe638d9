// What a command line says is read or refused with a UsageError, whatever it holds. An argument a line; the options of
// all commands that describe scenes, times, outputs, ensembles, pictures and windows.

#include "app/cli/command_line.hpp"

#include "app/cli/ensemble_options.hpp"
#include "app/cli/particle_list.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/view_options.hpp"
#include "app/commands/film_options.hpp"
#include "app/commands/film_times.hpp"
#include "app/commands/run_outputs.hpp"
#include "app/commands/snapshot_options.hpp"
#include "core/error.hpp"
#include "sim/catalogue.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace steplab;

std::vector<std::string> lines(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// With pairs near in space all particles are placed to count the pairs: right, but too slow for millions of inputs.
bool is_large(const std::string& word) {
    const std::size_t equals = word.find('=');
    return word.starts_with("edge") && equals != std::string::npos &&
           std::count_if(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }) > 1;
}

/// What every command with a scene reads first.
struct Scene {
    SceneOptions scene{SceneOptions::Methods::one_or_all};
    TimeOptions time{1000};
    EnsembleOptions ensemble;

    /// With the options of a command beside them. False where the help is asked for.
    template <class Options>
    bool takes(const std::vector<std::string>& words, Options& options) {
        CLI::App app("a command", "steplab");
        scene.declare(app);
        time.declare(app);
        ensemble.declare(app);
        options.declare(app);
        return !parse(app, words);
    }
    RunDescription read() const {
        const RunDescription run = scene.descriptions().front();
        time.end(run);
        if (ensemble.is_given() && ensemble.count() <= 100) ensemble.runs(run, ensemble.ranges(run), time);
        return run;
    }
};

void read_run(const std::vector<std::string>& words) {
    Scene scene;
    OutputOptions output;
    if (!scene.takes(words, output)) return;
    const RunDescription run = scene.read();
    output.check();
    const double particles = model_of(run).particles(run.scene);
    if (!output.particles.empty() && particles < 1e5)
        parse_particles("--particles", output.particles, static_cast<std::size_t>(particles));
}

void read_snapshot(const std::vector<std::string>& words) {
    Scene scene;
    SnapshotOptions picture;
    if (scene.takes(words, picture)) picture.request(scene.read());
}

void read_record(const std::vector<std::string>& words) {
    Scene scene;
    FilmOptions film;
    if (!scene.takes(words, film)) return;
    const RunDescription run = scene.read();
    film.format(film.request(run).size);
    FilmTimes(run, scene.time.end(run), scene.time.end_time(run), film.spacing()).end();
}

void read_view(const std::vector<std::string>& words) {
    CLI::App app("a command", "steplab");
    SceneOptions scene;
    ViewOptions window;  // with the options of time and ensemble
    scene.declare(app);
    window.declare(app);
    if (!parse(app, words)) window.request(window.runs(scene.descriptions().front()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::vector<std::string> words = lines({reinterpret_cast<const char*>(bytes), count});
    if (std::any_of(words.begin(), words.end(), is_large)) return 0;
    for (const auto read : {read_run, read_snapshot, read_record, read_view}) {
        try {
            read(words);
        } catch (const Error&) {
        }
    }
    return 0;
}
