#include "app/cli/command_line.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/cli/view_choices_file.hpp"
#include "app/cli/view_options.hpp"
#include "app/window/viewer.hpp"
#include "core/end_watch.hpp"
#include "core/error.hpp"
#include "core/freed_memory.hpp"
#include "core/program_end.hpp"
#include "io/commit.hpp"
#include "ui/keys.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace steplab;

/// The command that draws the same scene without a window.
std::string way_out(const RunDescription& description) {
    return "to draw without a display, use `steplab snapshot " + command_line(description) + " --out picture.png`";
}

int open_window(const RunDescription& description, const WindowRequest& request) {
    EndWatch watch(&Window::wake);  // a session or a film is to be written before the window ends
    std::optional<Viewer> viewer;
    try {
        viewer.emplace(description, request);
    } catch (const GraphicsError& error) {
        throw GraphicsError(fmt::format("{}; {}", error.what(), way_out(description)));
    }
    try {
        viewer->run(watch);
    } catch (const FileError& error) {
        print_aside(fmt::format("steplab-view: {}\n", error.what()));
        end_program_soon(static_cast<int>(error.code()));
        return static_cast<int>(error.code());
    }
    if (const auto signal = watch.signal()) end_program(128 + *signal);
    end_program_soon(static_cast<int>(ExitCode::done));  // the last step of the run may take longer than anybody waits
    return static_cast<int>(ExitCode::done);
}

int run(const std::vector<std::string>& arguments) {
    CLI::App app("Show a simulation in a window", "steplab-view");
    app.set_version_flag("--version", std::string("steplab-view ") + STEPLAB_VERSION);
    SceneOptions scene(SceneOptions::Defaults::recommended);
    ViewOptions options;
    bool keys = false;
    options.declare(app);
    flag_option(app, "--keys", keys, "Print the table of keys (Markdown) and exit");
    scene.declare(app);
    if (const auto text = parse(app, arguments)) {
        print(*text);
    } else if (keys) {
        print(ui::key_table());
    } else {
        GivenSession session = options.session(scene);
        const auto start = session.start();
        const std::vector<RunDescription> runs = start ? std::vector{*start} : options.runs(scene.description());
        const RunDescription& description = runs.front();
        WindowRequest request = options.request(runs, std::move(session));
        const ReadViewChoices remembered = read_view_choices(view_choices_path(request.config));
        if (remembered.problem) print_note("steplab-view", *remembered.problem);
        request.note = remembered.problem.value_or("");
        options.put_remembered(remembered.choices, description, request);
        request.scenes = !start && !scene.any_given();
        if (const auto note = options.note(description)) print_note("steplab-view", *note);
        return open_window(description, request);
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
    prepare_standard_streams();
    keep_no_freed_memory();
    return guarded("steplab-view", [&] { return run({argv + (argc > 0 ? 1 : 0), argv + argc}); });
}
