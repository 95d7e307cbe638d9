/// Writes the made sections of the given pages anew: update_docs PROGRAMS-FOLDER PAGE...

#include "sections.hpp"
#include "tables.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>

namespace {

void update(const std::string& path, const std::string& folder) {
    std::ostringstream page;
    page << std::ifstream(path).rdbuf();
    const auto make = [&](const std::string& name) { return steplab::docs::section(name, folder); };
    const std::string made = steplab::docs::with_sections_made(page.str(), make);
    if (made == page.str()) return;
    std::ofstream(path) << made;
    fmt::print("updated {}\n", path);
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        fmt::print(stderr, "usage: update_docs PROGRAMS-FOLDER PAGE...\n");
        return 2;
    }
    try {
        for (int i = 2; i < count; ++i) update(arguments[i], arguments[1]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "update_docs: {}\n", error.what());
        return 1;
    }
}
