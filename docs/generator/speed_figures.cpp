#include "speed_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steplab::docs {
namespace {

/// A scene of increasing size, in one precision.
struct Series {
    std::string_view row, name, precision;
    double springs;  ///< per particle
    double axes;     ///< along which it moves
    std::size_t colour;
};
constexpr std::array<Series, 4> all_series{{{"growing-chain", "chain", "double", 1, 1, 0},
                                            {"growing-chain", "chain", "float", 1, 1, 1},
                                            {"growing-mesh", "mesh", "double", 4, 3, 2},
                                            {"growing-mesh", "mesh", "float", 4, 3, 3}}};

plot::Curve curve_of(const Series& series, std::string name) {
    return {.name = std::move(name), .colour = series.colour};
}

/// Time per particle and step: one thread, and dashed the largest number of threads.
void add_growing(const Results& results, const Series& series, std::vector<plot::Curve>& curves) {
    const std::string precision(series.precision);
    plot::Curve one = curve_of(series, fmt::format("{}, {}", series.name, precision));
    plot::Curve threads = curve_of(series, "");
    threads.line = plot::Line::dashed;
    for (const Row* row : rows_of(results, series.row)) {
        if (const Time* time = own(*row, precision)) one.add(row->particles, time->particle);
        if (const Time* time = own_with(*row, precision)) {
            threads.name = fmt::format("{}, {}, {}", series.name, precision, time->who.substr(8));
            threads.add(row->particles, time->particle);
        }
    }
    curves.push_back(one);
    if (!threads.x.empty()) curves.push_back(threads);
}

plot::Plot growing(const Results& results) {
    plot::Plot figure{.x = {.name = "particles", .scale = plot::Scale::logarithmic, .numbers = plot::Numbers::counts},
                      .y = {.name = "time per particle and step", .unit = "ns", .scale = plot::Scale::logarithmic}};
    for (const Series& series : all_series) add_growing(results, series, figure.curves);
    return figure;
}

/// Of velocity-verlet: a sweep reads and writes positions and velocities.
double springs_per_byte(const Series& series) {
    const double number = series.precision == "double" ? sizeof(double) : sizeof(float);
    return series.springs / (4 * series.axes * number);
}

/// Springs per second of scenes too large to be bound by latency, one mark each.
void add_reached(const Results& results, const Series& series, std::vector<plot::Curve>& curves) {
    constexpr double many = 1e4;
    plot::Curve curve = curve_of(series, fmt::format("{}, {}", series.name, series.precision));
    for (const Row* row : rows_of(results, series.row)) {
        const Time* time = own(*row, std::string(series.precision));
        if (time && row->particles > 0.9 * many)
            curve.add(springs_per_byte(series), series.springs / time->particle * 1e9);
    }
    curves.push_back(curve);
}

/// A roof: springs per second at both ends of the diagram.
template <class Height>
void add_roof(std::string name, std::size_t colour, bool dashed, Height height, std::vector<plot::Curve>& curves) {
    constexpr double from = 0.005, to = 0.2;
    plot::Curve roof{
        .name = std::move(name), .colour = colour, .line = plot::dashed_if(dashed), .marks = plot::Marks::never};
    for (const double x : {from, to}) roof.add(x, height(x));
    curves.push_back(roof);
}

plot::Plot roofline(const Results& results) {
    plot::Plot figure{.x = {.name = "springs per byte read or written", .scale = plot::Scale::logarithmic},
                      .y = {.name = "springs per second", .scale = plot::Scale::logarithmic}};
    for (const Series& series : all_series) add_reached(results, series, figure.curves);
    std::size_t colour = 4;
    for (const Bandwidth& each : bandwidths(results)) {
        add_roof(
            fmt::format("{} ({:.0f} GB/s)", size_text(each.size), each.bytes_per_second / 1e9), colour++, false,
            [&](double x) { return x * each.bytes_per_second; }, figure.curves);
    }
    for (const Row* row : rows_of(results, "machine-springs")) {
        for (const std::string precision : {"double", "float"}) {
            const double most = 1e9 / machine_time(*row, precision);
            add_roof(
                "square roots and divisions, " + precision, colour++, true, [=](double) { return most; },
                figure.curves);
        }
    }
    return figure;
}

}  // namespace

std::vector<SpeedFigure> speed_figures(const Results& results) {
    if (rows_of(results, "growing-chain").empty()) return {};
    return {{speed_picture_name(results, "growing"), growing(results)},
            {speed_picture_name(results, "roofline"), roofline(results)}};
}

std::string speed_picture_name(const Results& results, std::string_view of) {
    return fmt::format("speed-{}-{}.svg", results.name, of);
}

std::string size_text(double bytes) {
    constexpr double kilo = 1024;
    return bytes < kilo * kilo ? fmt::format("{:.0f} KiB", bytes / kilo)
                               : fmt::format("{:.0f} MiB", bytes / (kilo * kilo));
}

}  // namespace steplab::docs
