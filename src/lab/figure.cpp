#include "lab/figure.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace steplab {

namespace {

/// Paul Tol's "bright" and "muted" colours, which colour-blind people tell apart.
constexpr std::array palette{"#4477aa", "#ee6677", "#228833", "#b8a400", "#44aacc", "#aa3377", "#777777",
                             "#332288", "#88ccee", "#117733", "#999933", "#cc6677", "#882255", "#aa4499"};

/// A folder that is gone when this object is.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "steplab-XXXXXX").string();
        if (!mkdtemp(name.data())) throw FileError(fmt::format("no temporary folder can be made as '{}'", name));
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

std::string data_block(const Figure& figure, std::size_t number) {
    std::string text;
    for (std::size_t c = 0; c < figure.curves.size(); ++c) {
        text += fmt::format("$f{}c{} << END\n", number, c);
        for (const auto& [x, y] : figure.curves[c].points) {
            const bool shown =
                std::isfinite(x) && std::isfinite(y) && (!figure.log_x || x > 0) && (!figure.log_y || y > 0);
            if (shown) text += number_text(x) + " " + number_text(y) + "\n";
        }
        text += "END\n";
    }
    return text;
}

std::string curve_command(const Figure& figure, std::size_t number, std::size_t c) {
    const Curve& curve = figure.curves[c];
    const std::size_t colour = static_cast<std::size_t>(curve.colour) % palette.size();
    const std::string marks = fmt::format(" pt {} ps 0.45", curve.dashed ? 6 : 7);
    return fmt::format("$f{}c{} using 1:2 with {} lc rgb '{}' lw 1.6 dt {}{} title '{}'", number, c,
                       curve.marks ? "linespoints" : "lines", palette[colour], curve.dashed ? 2 : 1,
                       curve.marks ? marks : "", curve.name);
}

/// Gnuplot refuses to draw a diagram without a point.
bool has_points(const Figure& figure) {
    for (const Curve& curve : figure.curves) {
        for (const auto& [x, y] : curve.points) {
            if (std::isfinite(x) && std::isfinite(y) && (!figure.log_x || x > 0) && (!figure.log_y || y > 0))
                return true;
        }
    }
    return false;
}

std::string commands(const Figure& figure, std::size_t number, const std::string& file) {
    std::string text = data_block(figure, number);
    text += fmt::format("set terminal svg size 620,430 dynamic font 'sans-serif,12' name 'f{}'\n", number);
    text += fmt::format("set output '{}'\nset xlabel '{}'\nset ylabel '{}'\n", file, figure.x_label, figure.y_label);
    text += figure.log_x ? "set logscale x\nset format x '10^{%T}'\n" : "unset logscale x\nset format x '%g'\n";
    text += figure.log_y ? "set logscale y\nset format y '10^{%T}'\n" : "unset logscale y\nset format y '%g'\n";
    text += figure.y_range ? fmt::format("set yrange [{}:{}]\n", figure.y_range->first, figure.y_range->second)
                           : std::string("set yrange [*:*]\n");
    text += "plot ";
    for (std::size_t c = 0; c < figure.curves.size(); ++c)
        text += (c ? ", \\\n" : "") + curve_command(figure, number, c);
    return text + "\nset output\n";
}

constexpr const char* style = R"(set encoding utf8
set border 3 lc rgb '#888888'
set tics nomirror textcolor rgb '#555555'
set grid lc rgb '#e0e0e0' lt 1 lw 0.6
set xlabel textcolor rgb '#333333'
set ylabel textcolor rgb '#333333'
set key outside right top textcolor rgb '#333333' samplen 1.2 width -2 font ',10'
)";

void run_gnuplot(const std::string& script) {
    const std::array<const char*, 3> arguments{"gnuplot", script.c_str(), nullptr};
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, arguments[0], nullptr, nullptr, const_cast<char**>(arguments.data()), environ);
    int status = 0;
    if (error == 0) waitpid(child, &status, 0);
    if (error == 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    throw FileError("gnuplot, which draws the diagrams of the report, cannot be run: install the package gnuplot-nox");
}

/// The <svg> element alone, without the prologue of a file of its own.
std::string svg_element(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    const std::string all = text.str();
    const std::size_t begin = all.find("<svg");
    return begin == std::string::npos ? std::string() : all.substr(begin);
}

}  // namespace

std::vector<std::string> svg_figures(std::span<const Figure> figures) {
    const TemporaryFolder folder;
    std::string script = style;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (has_points(figures[i])) script += commands(figures[i], i, folder.file(fmt::format("{}.svg", i)));
    }
    const std::string file = folder.file("figures.gp");
    std::ofstream(file) << script;
    run_gnuplot(file);
    std::vector<std::string> elements;
    for (std::size_t i = 0; i < figures.size(); ++i)
        elements.push_back(svg_element(folder.file(fmt::format("{}.svg", i))));
    return elements;
}

}  // namespace steplab
