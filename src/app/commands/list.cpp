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
        text_option(app, "kind", kind_, "models|methods",
                    "Only these, with all their parameters (default: both, in short)");
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
    /// Short tables of both, or one of the lists with all parameters.
    static std::string tables(bool with_models, bool with_methods) {
        if (!with_methods) return models_with_parameters();
        if (!with_models) return methods_table() + '\n' + methods_with_parameters();
        return models_table() + '\n' + methods_table();
    }

    std::string kind_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> list_command() { return std::make_unique<ListCommand>(); }

}  // namespace steplab
