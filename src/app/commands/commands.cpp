#include "app/commands/commands.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/advise.hpp"
#include "app/commands/bench.hpp"
#include "app/commands/cluster.hpp"
#include "app/commands/compare.hpp"
#include "app/commands/convert.hpp"
#include "app/commands/crosscheck.hpp"
#include "app/commands/export.hpp"
#include "app/commands/hard_cases.hpp"
#include "app/commands/limits.hpp"
#include "app/commands/list.hpp"
#include "app/commands/observe.hpp"
#include "app/commands/record.hpp"
#include "app/commands/replay.hpp"
#include "app/commands/report.hpp"
#include "app/commands/run.hpp"
#include "app/commands/snapshot.hpp"
#include "app/commands/view.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/commit.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace steplab {

namespace {

using Commands = std::vector<std::unique_ptr<Command>>;

constexpr std::string_view help_command = "help";
constexpr std::string_view version_text = "steplab " STEPLAB_VERSION "\n";

std::string program_help(const Commands& all) {
    std::string text =
        "steplab: a laboratory for numerical integrators of point masses, in a window or on the command line\n\n";
    text += "Usage: steplab [COMMAND] [OPTIONS]\n\nCommands:\n";
    for (const auto& command : all) text += fmt::format("  {:<12}{}\n", command->name(), command->what());
    text += fmt::format("  {:<12}{}\n", help_command, "Print this help, or that of a command");
    text += "\nWithout a command, the scene opens in a window: steplab --model rope --dt 0.02\n";
    text += "Options of a command: steplab help COMMAND, or steplab COMMAND --help\n";
    text += catalogue_hint() + '\n';
    text += "Version: steplab --version\n\n";
    text += "Exit codes: 0 done, 2 wrong command line, 3 a file cannot be read or written,\n";
    text += "4 the run diverged or stopped, 5 no OpenGL, 6 a repeated run differs, 128 + n ended by signal n\n";
    return text;
}

int run_command(Command& command, std::vector<std::string> arguments) {
    CLI::App app(std::string(command.what()), fmt::format("steplab {}", command.name()));
    command.declare(app);
    if (const auto text = parse(app, std::move(arguments))) {
        print(*text);
        return static_cast<int>(ExitCode::done);
    }
    return command.run();
}

Command& find_command(const Commands& all, std::string_view name) {
    std::vector<std::string_view> known;
    for (const auto& command : all) {
        if (command->name() == name) return *command;
        known.push_back(command->name());
    }
    known.push_back(help_command);
    throw UsageError(unknown_word("command", name, known));
}

/// `steplab help` and `steplab help COMMAND`.
int print_help(const Commands& all, const std::vector<std::string>& arguments) {
    if (arguments.size() > 1) throw UsageError("help takes the name of one command");
    const std::string name = arguments.empty() ? "" : arguments.front();
    const bool whole = name.empty() || name == help_command || name == "--help" || name == "-h";
    if (!whole) return run_command(find_command(all, name), {"--help"});
    print(program_help(all));
    return static_cast<int>(ExitCode::done);
}

}  // namespace

std::vector<std::unique_ptr<Command>> commands(const std::vector<std::string>& arguments) {
    Commands all;
    all.push_back(list_command());
    all.push_back(run_command());
    all.push_back(convert_command());
    all.push_back(observe_command());
    all.push_back(export_command());
    all.push_back(snapshot_command());
    all.push_back(record_command());
    all.push_back(compare_command());
    all.push_back(cluster_command());
    all.push_back(crosscheck_command());
    all.push_back(replay_command());
    all.push_back(limits_command());
    all.push_back(hard_cases_command());
    all.push_back(report_command());
    all.push_back(advise_command());
    all.push_back(bench_command());
    all.push_back(view_command(arguments));
    return all;
}

int run_steplab(std::vector<std::string> arguments) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    const bool bare = first.empty() || first.starts_with('-');  // options of a scene: the window
    std::string program = "steplab";  // begins every message; followed by the command once it is known
    if (!bare) arguments.erase(arguments.begin());
    return guarded(program, [&] {
        const Commands all = commands(arguments);
        if (first == "--version") return print(version_text), static_cast<int>(ExitCode::done);
        if (first == "--help" || first == "-h") return print_help(all, {});
        if (first == help_command) return print_help(all, arguments);
        Command& command = find_command(all, bare ? "view" : first);
        if (!bare) program += fmt::format(" {}", command.name());
        return run_command(command, arguments);
    });
}

}  // namespace steplab
