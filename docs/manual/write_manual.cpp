// Writes the pages of the manual and the completions of shells into a folder, from what the command line says of
// itself: write_manual FOLDER
#include "completion.hpp"
#include "man_page.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file);
    stream << text;
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    stream.flush();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace steplab::manual;
    if (argc != 2) {
        std::fputs("usage: write_manual FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    for (const char* part : {"man1", "bash", "zsh"}) std::filesystem::create_directories(folder / part);
    const auto commands = described_commands();
    write(folder / "man1/steplab.1", man_page(commands));
    for (const DescribedCommand& command : commands) {
        write(folder / "man1" / ("steplab-" + command.name + ".1"), man_page(command, "steplab " + command.name));
    }
    write(folder / "bash/steplab", bash_completion(commands));
    write(folder / "zsh/_steplab", zsh_completion(commands));
}
