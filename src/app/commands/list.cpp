#include "app/commands/list.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/scene_listing.hpp"
#include "app/cli/scene_options.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/scene_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace steplab {

namespace {

class ListCommand final : public Command {
public:
    std::string_view name() const override { return "list"; }
    std::string_view what() const override {
        return "List the models, methods and shipped scenes, or say what one scene consists of";
    }

    void declare(CLI::App& app) override {
        text_option(app, "kind", kind_, "models|methods|scenes|scene",
                    "Only these, with all their parameters (default: models and methods, in short); scene: what the "
                    "one of the options below consists of, and how it is stepped");
        flag_option(app, "--json", json_, "Print JSON with all data of the entries");
        scene_.declare(app);
    }

    int run() override {
        constexpr std::array<std::string_view, 4> kinds{"models", "methods", "scenes", "scene"};
        if (!kind_.empty() && std::find(kinds.begin(), kinds.end(), kind_) == kinds.end())
            throw UsageError(unknown_word("list", kind_, kinds));
        if (kind_ == kinds[3]) {
            const SceneListing scene = scene_listing(scene_.description());
            print(json_ ? scene_json(scene) : scene_text(scene));
            return static_cast<int>(ExitCode::done);
        }
        if (scene_.any_given()) throw UsageError("the options of a scene belong to `steplab list scene`");
        if (kind_ == kinds[2]) {
            print(json_ ? scenes_json() : scenes_table());
            return static_cast<int>(ExitCode::done);
        }
        const bool with_models = kind_ != kinds[1];
        const bool with_methods = kind_ != kinds[0];
        print(json_ ? catalogue_json(with_models, with_methods) : tables(with_models, with_methods));
        return static_cast<int>(ExitCode::done);
    }

private:
    /// Short tables of both, or one of the lists with all parameters.
    static std::string tables(bool with_models, bool with_methods) {
        if (!with_methods) return models_with_parameters();
        if (!with_models) return methods_table() + '\n' + methods_with_parameters();
        return models_table() + '\n' + methods_table();
    }

    static std::string scenes_table() {
        std::string text;
        for (const std::string& name : shipped_scenes()) {
            const auto scene = find_scene(name);  // owns the texts
            const ModelInfo& info = scene->model->info;
            text += fmt::format("{:<24}{}\n", name, info.name);
        }
        return text;
    }
    static std::string scenes_json() {
        auto scenes = nlohmann::ordered_json::array();
        for (const std::string& name : shipped_scenes()) {
            const auto scene = find_scene(name);
            const ModelInfo& info = scene->model->info;
            scenes.push_back({{"id", name}, {"title", info.name}, {"teaches", info.what}});
        }
        return scenes.dump(2) + "\n";
    }

    SceneOptions scene_;
    std::string kind_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> list_command() { return std::make_unique<ListCommand>(); }

}  // namespace steplab
