/// Draws the diagrams of docs/hard-cases.md: draw_diagrams FOLDER [ID...]

#include "lab/page.hpp"
#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <regex>
#include <span>
#include <string>
#include <vector>

namespace {

/// Without tabs and blanks at the end of a line, which gnuplot leaves.
std::string tidy(const std::string& text) {
    static const std::regex tabs("\t"), ends("[ \t\r]+\n");
    return std::regex_replace(std::regex_replace(text, ends, "\n"), tabs, " ");
}

void draw(const std::string& folder, const std::vector<std::string>& wanted) {
    for (const steplab::HardCase& each : steplab::hard_cases()) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), each.id) == wanted.end()) continue;
        const steplab::Figure figure = each.figure();
        const std::string path = folder + "/" + steplab::docs::picture_name(each);
        std::ofstream(path) << tidy(steplab::svg_file(steplab::svg_figures(std::span(&figure, 1)).front()));
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
