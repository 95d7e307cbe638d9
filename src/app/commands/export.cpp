#include "app/commands/export.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/scene_options.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/scene_export.hpp"

#include <array>
#include <string>

namespace steplab {

namespace {

constexpr std::array<std::string_view, 1> formats{"scene"};

class ExportCommand final : public Command {
public:
    std::string_view name() const override { return "export"; }
    std::string_view what() const override { return "Write a scene as a file"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        text_option(app, "--to", to_, "scene", "Kind of file: scene, TOML for --scene");
        text_option(app, "--out", out_, "FILE|-", "Output file (default -, standard output)");
    }

    int run() override {
        if (to_.empty()) throw UsageError("--to is required: --to scene");
        if (to_ != formats[0]) throw UsageError(unknown_word("kind of file", to_, formats));
        write_scene(out_, scene_.description());
        return static_cast<int>(ExitCode::done);
    }

private:
    SceneOptions scene_;
    std::string to_;
    std::string out_ = "-";
};

}  // namespace

std::unique_ptr<Command> export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace steplab
