#include "app/commands/view.hpp"

#include "app/cli/scene_options.hpp"
#include "app/cli/view_options.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr std::string_view window_program = "steplab-view";

std::filesystem::path beside_this_program(std::string_view name) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    return self.parent_path() / name;
}

class ViewCommand final : public Command {
public:
    explicit ViewCommand(std::vector<std::string> arguments) : arguments_(std::move(arguments)) {}
    std::string_view name() const override { return "view"; }
    std::string_view what() const override { return "Open the scene in a window"; }
    void declare(CLI::App& app) override {
        scene_.declare(app);
        window_.declare(app);
    }

    int run() override {
        const GivenSession session = window_.session(scene_);  // what is wrong is reported before a window opens
        const auto start = session.start();
        window_.request(start ? std::vector{*start} : window_.runs(scene_.description()), session);
        const std::filesystem::path program = beside_this_program(window_program);
        arguments_.insert(arguments_.begin(), std::string(window_program));
        std::vector<char*> argv;
        for (std::string& argument : arguments_) argv.push_back(argument.data());
        argv.push_back(nullptr);
        std::signal(SIGPIPE, SIG_DFL);  // ignored signals would stay ignored there
        std::signal(SIGXFSZ, SIG_DFL);
        execv(program.c_str(), argv.data());
        throw GraphicsError(
            fmt::format("cannot start the window program '{}': {}; without a window, use `steplab snapshot` for "
                        "pictures and `steplab run` for results",
                        program.string(), std::generic_category().message(errno)));
    }

private:
    SceneOptions scene_{SceneOptions::Defaults::recommended};
    ViewOptions window_;
    std::vector<std::string> arguments_;
};

}  // namespace

std::unique_ptr<Command> view_command(std::vector<std::string> arguments) {
    return std::make_unique<ViewCommand>(std::move(arguments));
}

}  // namespace steplab
