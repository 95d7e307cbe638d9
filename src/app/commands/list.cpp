#include "app/commands/list.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/scene_listing.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/cli/text_table.hpp"
#include "core/error.hpp"
#include "core/terms.hpp"
#include "core/text.hpp"
#include "io/scene_file.hpp"
#include "session/lesson.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace steplab {

namespace {

/// What one line of a list says.
struct Titled {
    std::string id, title, teaches;
};

class ListCommand final : public Command {
public:
    std::string_view name() const override { return "list"; }
    std::string_view what() const override {
        return "List models, methods, scenes, lessons and terms, or what one scene consists of";
    }

    void declare(CLI::App& app) override {
        text_option(app, "kind", kind_, "models|methods|scenes|lessons|terms|scene",
                    "Only these, with all their parameters (default: models and methods, in short); scene: what the "
                    "one of the options below consists of, and how it is stepped");
        flag_option(app, "--json", json_, "Print JSON with all data of the entries");
        scene_.declare(app);
    }

    int run() override {
        constexpr std::array<std::string_view, 6> kinds{"models", "methods", "scenes", "scene", "lessons", "terms"};
        if (!kind_.empty() && std::find(kinds.begin(), kinds.end(), kind_) == kinds.end())
            throw UsageError(unknown_word("list", kind_, kinds));
        if (kind_ == kinds[3]) {
            const SceneListing scene = scene_listing(scene_.description());
            json_ ? print_data(scene_json(scene)) : print(scene_text(scene));
            return static_cast<int>(ExitCode::done);
        }
        if (scene_.any_given()) throw UsageError("the options of a scene belong to `steplab list scene`");
        if (kind_ == kinds[2] || kind_ == kinds[4] || kind_ == kinds[5]) {
            const std::vector<Titled> all = kind_ == kinds[2]   ? scenes()
                                            : kind_ == kinds[4] ? lessons()
                                                                : explained_terms();
            json_ ? print_data(json(all)) : print(table(all));
            return static_cast<int>(ExitCode::done);
        }
        const bool with_models = kind_ != kinds[1];
        const bool with_methods = kind_ != kinds[0];
        json_ ? print_data(catalogue_json(with_models, with_methods)) : print(tables(with_models, with_methods));
        return static_cast<int>(ExitCode::done);
    }

private:
    /// Short tables of both, or one of the lists with all parameters.
    static std::string tables(bool with_models, bool with_methods) {
        if (!with_methods) return models_with_parameters();
        if (!with_models) return methods_table() + '\n' + methods_with_parameters();
        return models_table() + '\n' + methods_table();
    }

    static std::vector<Titled> scenes() {
        std::vector<Titled> all;
        for (const std::string& name : shipped_scenes()) {
            const auto scene = find_scene(name);  // owns the texts
            all.push_back({name, std::string(scene->model->info.name), std::string(scene->model->info.what)});
        }
        return all;
    }
    static std::vector<Titled> lessons() {
        std::vector<Titled> all;
        for (const Lesson& lesson : shipped_lessons()) all.push_back({lesson.id, lesson.title, lesson.teaches});
        return all;
    }
    /// Words with what they mean.
    static std::vector<Titled> explained_terms() {
        std::vector<Titled> all;
        for (const Term& term : terms()) all.push_back({std::string(term.id), std::string(term.text), {}});
        return all;
    }

    static std::string table(const std::vector<Titled>& all) {
        std::vector<Row> rows;
        rows.reserve(all.size());
        for (const Titled& each : all) rows.push_back({each.id, each.title});
        return rows.empty() ? "" : aligned(rows, 0);
    }
    static std::string json(const std::vector<Titled>& all) {
        auto list = nlohmann::ordered_json::array();
        for (const Titled& each : all) {
            list.push_back({{"id", each.id}, {"title", each.title}});
            if (!each.teaches.empty()) list.back()["teaches"] = each.teaches;
        }
        return list.dump(2) + "\n";
    }

    SceneOptions scene_;
    std::string kind_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> list_command() { return std::make_unique<ListCommand>(); }

}  // namespace steplab
