#include "app/commands/hard_cases.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/hard_cases_text.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"

#include <string>
#include <vector>

namespace steplab {

namespace {

constexpr const char* hard_case_examples =
    "Examples:\n"
    "  steplab hard-cases\n"
    "  steplab hard-cases stiff-rope\n"
    "  steplab hard-cases chaos --json";

class HardCasesCommand final : public Command {
public:
    std::string_view name() const override { return "hard-cases"; }
    std::string_view what() const override { return "Run scenes at which methods fail, with every method"; }

    void declare(CLI::App& app) override {
        text_option(app, "name", name_, "NAME", "Case to run (default: list all cases)");
        flag_option(app, "--json", json_, "Print JSON", "Output");
        footer(app, [] { return std::string(hard_case_examples); });
    }

    int run() override {
        const std::string text = name_.empty() ? list() : table_of(hard_case(name_));
        json_ ? print_data(text) : print(text);
        return static_cast<int>(ExitCode::done);
    }

private:
    std::string list() const {
        const std::vector<HardCase> all = hard_cases();
        return json_ ? hard_cases_json(all) : hard_cases_list(all);
    }

    std::string table_of(const HardCase& hard_case) const {
        catch_interruptions();
        const Table table = hard_case.table();
        return json_ ? hard_case_json(hard_case, table) : hard_case_text(hard_case, table);
    }

    std::string name_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> hard_cases_command() { return std::make_unique<HardCasesCommand>(); }

}  // namespace steplab
