#include "app/window/icon.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {
namespace {

constexpr int side = 64;

struct Colour {
    double red, green, blue;
};

struct Disc {
    double x, y, radius;  ///< relative to the side
    Colour colour;
};

constexpr std::array<Disc, 3> discs = {
    {{0.22, 0.68, 0.15, {78, 161, 255}}, {0.50, 0.34, 0.15, {63, 179, 127}}, {0.78, 0.68, 0.15, {253, 231, 37}}}};
constexpr Colour ground = {28, 33, 40};
constexpr Colour spring = {150, 160, 175};

/// 1 inside, 0 outside, with a transition of one pixel.
double coverage(double distance_inside) { return std::clamp(distance_inside * side + 0.5, 0.0, 1.0); }

Colour mix(Colour a, Colour b, double part) {
    const auto one = [&](double from, double to) { return from + part * (to - from); };
    return {one(a.red, b.red), one(a.green, b.green), one(a.blue, b.blue)};
}

double distance_to_segment(double x, double y, const Disc& a, const Disc& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double along = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - a.x - along * dx, y - a.y - along * dy);
}

Colour colour_at(double x, double y) {
    Colour colour = ground;
    for (std::size_t i = 1; i < discs.size(); ++i) {
        colour = mix(colour, spring, coverage(0.025 - distance_to_segment(x, y, discs[i - 1], discs[i])));
    }
    for (const Disc& disc : discs) {
        const double distance = std::hypot(x - disc.x, y - disc.y);
        const double light = 1 - 0.45 * std::hypot(x - disc.x + 0.05, y - disc.y + 0.06) / disc.radius;
        const Colour lit = mix({0, 0, 0}, disc.colour, std::clamp(light + 0.2, 0.0, 1.0));
        colour = mix(colour, lit, coverage(disc.radius - distance));
    }
    return colour;
}

/// The part of the pixel within the rounded square.
double opacity(double x, double y) {
    constexpr double corner = 0.18;
    const double dx = std::max(std::abs(x - 0.5) - (0.5 - corner), 0.0);
    const double dy = std::max(std::abs(y - 0.5) - (0.5 - corner), 0.0);
    return coverage(corner - std::hypot(dx, dy));
}

}  // namespace

void set_icon(GLFWwindow* window) {
    std::vector<std::uint8_t> pixels;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = (column + 0.5) / side;
            const double y = (row + 0.5) / side;
            const Colour colour = colour_at(x, y);
            for (const double value : {colour.red, colour.green, colour.blue, 255 * opacity(x, y)}) {
                pixels.push_back(static_cast<std::uint8_t>(std::lround(value)));
            }
        }
    }
    const GLFWimage image{side, side, pixels.data()};
    glfwSetWindowIcon(window, 1, &image);
}

}  // namespace steplab
