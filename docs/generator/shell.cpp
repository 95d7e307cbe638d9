#include "shell.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <sys/wait.h>

namespace steplab::docs {
namespace {

/// `text` as one word of a shell.
std::string quoted(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

}  // namespace

Outcome run(const std::string& command, const std::filesystem::path& folder, const std::filesystem::path& programs) {
    const std::string line = "cd " + quoted(folder.string()) + " && exec env -u DISPLAY -u WAYLAND_DISPLAY PATH=" +
                             quoted(std::filesystem::absolute(programs).string()) + ":\"$PATH\" bash -c " +
                             quoted(command) + " </dev/null";
    FILE* pipe = popen(line.c_str(), "r");
    if (!pipe) throw std::runtime_error("no shell to run: " + command);
    Outcome outcome;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        outcome.output.append(buffer.data(), size);
    }
    const int status = pclose(pipe);
    outcome.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return outcome;
}

}  // namespace steplab::docs
