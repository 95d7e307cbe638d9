/// Draws the diagrams of docs/hard-cases.md: draw_diagrams FOLDER [ID...]

#include "lab/page.hpp"
#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace {

void draw(const std::string& folder, const std::vector<std::string>& wanted) {
    for (const steplab::HardCase& each : steplab::hard_cases()) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), each.id) == wanted.end()) continue;
        const steplab::Figure figure = each.figure();
        const std::string path = folder + "/" + steplab::docs::picture_name(each);
        std::ofstream(path) << steplab::svg_file(steplab::svg_figures(std::span(&figure, 1)).front());
        fmt::print("{}\n", path);
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        fmt::print(stderr, "usage: draw_diagrams FOLDER [ID...]\n");
        return 2;
    }
    try {
        draw(arguments[1], {arguments + 2, arguments + count});
    } catch (const std::exception& error) {
        fmt::print(stderr, "draw_diagrams: {}\n", error.what());
        return 1;
    }
}
