#include "app/commands/bench.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/bench_text.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"

#include <string>
#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* notes =
    "Examples:\n"
    "  steplab bench\n"
    "  steplab bench --method rk4 --json\n\n"
    "It takes less than a minute and is most accurate on an otherwise idle machine.";

class BenchCommand final : public Command {
public:
    std::string_view name() const override { return "bench"; }
    std::string_view what() const override { return "Measure the time per step on this machine and what limits it"; }

    void declare(CLI::App& app) override {
        text_option(app, "--method", method_, "ID", "Integration method (default velocity-verlet)");
        flag_option(app, "--json", json_, "Print JSON, times in seconds", "Output");
        footer(app, [] { return std::string(notes); });
    }

    int run() override {
        catch_interruptions();
        Progress progress(1, isatty(STDERR_FILENO) != 0);
        const MachineSpeed speed = measure_machine(method_.empty() ? "velocity-verlet" : method_, [&](double part) {
            check_interruption();
            progress.at_part(part);
        });
        progress.clear();
        json_ ? print_data(bench_json(speed)) : print(bench_text(speed));
        return static_cast<int>(ExitCode::done);
    }

private:
    std::string method_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> bench_command() { return std::make_unique<BenchCommand>(); }

}  // namespace steplab
