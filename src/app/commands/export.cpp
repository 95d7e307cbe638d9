#include "app/commands/export.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/scene_options.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/scene_writer.hpp"
#include "io/starting_values_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string>
#include <system_error>

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
        const RunDescription run = scene_.description();
        if (!run.start.is_none())
            throw UsageError(
                "a scene file is written with the start of its scene: give --from and --reverse to the run");
        const std::string text = scene_file_text(run);
        if (run.origin && out_ != "-") write_read_files(*run.origin);
        OutputFile file(out_);
        file.write(text);
        file.commit();
        return static_cast<int>(ExitCode::done);
    }

private:
    /// The files that the scene reads lie beside it, as they did.
    void write_read_files(const SceneFile& scene) const {
        const std::filesystem::path folder = std::filesystem::path(out_).parent_path();
        for (const SceneFile::Part& part : scene.parts) {
            const std::string name = (folder / file_at_step(part.name).file).string();
            if (part.name.empty() || holds(name, part.content)) continue;
            OutputFile file(name);
            file.write(part.content);
            file.commit();
        }
    }

    /// True if the file is there with this content. Throws FileError if it has another one.
    static bool holds(const std::string& name, const std::string& content) {
        std::error_code error;
        if (!std::filesystem::exists(name, error)) return false;
        const InputFile file(name);
        if (file.size() == content.size() && file.read(0, file.size()) == content) return true;
        throw FileError(fmt::format("'{}', which the scene reads, is there with other content", shown(name)));
    }

    SceneOptions scene_;
    std::string to_;
    std::string out_ = "-";
};

}  // namespace

std::unique_ptr<Command> export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace steplab
