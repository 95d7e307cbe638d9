#include "app/commands/list.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

#include <array>
#include <string>

namespace steplab {

namespace {

class ListCommand final : public Command {
public:
    std::string_view name() const override { return "list"; }
    std::string_view what() const override { return "List the models and methods"; }

    void declare(CLI::App& app) override {
        text_option(app, "kind", kind_, "models|methods", "List only these (default both)");
        flag_option(app, "--json", json_, "Print JSON with all data of the entries");
    }

    int run() override {
        constexpr std::array<std::string_view, 2> kinds{"models", "methods"};
        if (!kind_.empty() && kind_ != kinds[0] && kind_ != kinds[1])
            throw UsageError(unknown_word("list", kind_, kinds));
        const bool with_models = kind_ != kinds[1];
        const bool with_methods = kind_ != kinds[0];
        print(json_ ? catalogue_json(with_models, with_methods) : tables(with_models, with_methods));
        return static_cast<int>(ExitCode::done);
    }

private:
    static std::string tables(bool with_models, bool with_methods) {
        const std::string between = with_models && with_methods ? "\n" : "";
        return (with_models ? models_table() : "") + between + (with_methods ? methods_table() : "");
    }

    std::string kind_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> list_command() { return std::make_unique<ListCommand>(); }

}  // namespace steplab
