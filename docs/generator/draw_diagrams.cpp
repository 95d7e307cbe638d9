/// Draws the diagrams of docs/hard-cases.md and docs/performance.md: draw_diagrams FOLDER [ID of a hard case |
/// speed]...

#include "lab/report/page.hpp"
#include "plot/svg.hpp"
#include "speed_figures.hpp"
#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

void draw(const std::string& path, const steplab::plot::Plot& figure) {
    std::ofstream(path) << steplab::plot::svg_element(figure, steplab::light_inks());
    fmt::print("{}\n", path);
}

void draw_all(const std::string& folder, const std::vector<std::string>& wanted) {
    const auto is_wanted = [&](std::string_view id) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), id) != wanted.end();
    };
    for (const steplab::HardCase& each : steplab::hard_cases()) {
        if (is_wanted(each.id)) draw(folder + "/" + steplab::docs::picture_name(each), each.figure());
    }
    if (!is_wanted("speed")) return;
    for (const auto& results : steplab::docs::read_results(STEPLAB_RESULTS)) {
        for (const auto& each : steplab::docs::speed_figures(results)) draw(folder + "/" + each.file, each.figure);
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        fmt::print(stderr, "usage: draw_diagrams FOLDER [ID of a hard case | speed]...\n");
        return 2;
    }
    try {
        draw_all(arguments[1], {arguments + 2, arguments + count});
    } catch (const std::exception& error) {
        fmt::print(stderr, "draw_diagrams: {}\n", error.what());
        return 1;
    }
}
