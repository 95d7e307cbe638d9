#include "app/cli/command_line.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/commands.hpp"
#include "core/freed_memory.hpp"

int main(int argc, char** argv) {
    steplab::prepare_standard_streams();
    steplab::keep_no_freed_memory();
    return steplab::guarded("steplab", [&] { return steplab::run_steplab({argv + (argc > 0 ? 1 : 0), argv + argc}); });
}
