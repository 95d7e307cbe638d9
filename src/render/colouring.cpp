#include "render/colouring.hpp"

#include "core/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace steplab::render {
namespace {

// Sixteen evenly spaced colours of the colour map by S. van der Walt and N. Smith (2015).
constexpr std::array<Rgb, 16> viridis_stops = {rgb(0x440154), rgb(0x481a6c), rgb(0x472f7d), rgb(0x414487),
                                               rgb(0x39568c), rgb(0x31688e), rgb(0x2a788e), rgb(0x23888e),
                                               rgb(0x1f988b), rgb(0x22a884), rgb(0x35b779), rgb(0x54c568),
                                               rgb(0x7ad151), rgb(0xa5db36), rgb(0xd2e21b), rgb(0xfde725)};

Rgb mixed(Rgb a, Rgb b, double part) {
    const auto channel = [part](std::uint8_t from, std::uint8_t to) {
        const double rounded_down = from + part * (to - from) + 0.5;
        return static_cast<std::uint8_t>(rounded_down);
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// Length of a vector between points that are drawable().
double size_of(Vec3 v) { return std::sqrt(dot(v, v)); }

double particle_value(const Frame& frame, const Style& style, std::size_t i) {
    switch (style.colouring) {
        case Colouring::speed:
            return size_of(frame.velocities[i]);
        case Colouring::kinetic_energy:
            return 0.5 * style.mass * dot(frame.velocities[i], frame.velocities[i]);
        default:
            return size_of(frame.positions[i] - frame.shape->rest[i]);
    }
}

double strain(const Frame& frame, const Spring& spring) {
    const double now = size_of(frame.positions[spring.second] - frame.positions[spring.first]);
    // A spring without rest length has no strain: its length is the measure of its extension.
    return spring.rest_length > 0 ? now / spring.rest_length - 1 : now;
}

// Leading digits of the ends of colour scales: closer to each other than those of ticks.
constexpr double scale_digits[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};

double largest_value(const Frame& frame, const Style& style) {
    double largest = 0;
    if (style.colouring == Colouring::strain) {
        for (const Spring& spring : frame.shape->springs) largest = std::max(largest, std::abs(strain(frame, spring)));
    } else {
        for (std::size_t i = 0; i < frame.positions.size(); ++i) {
            largest = std::max(largest, particle_value(frame, style, i));
        }
    }
    return largest;
}

}  // namespace

Rgb viridis(double part) {
    const double place = std::clamp(part, 0.0, 1.0) * (viridis_stops.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(place), viridis_stops.size() - 2);
    return mixed(viridis_stops[lower], viridis_stops[lower + 1], place - static_cast<double>(lower));
}

Rgb ColourScale::colour(double value, const Palette& palette) const {
    if (colouring != Colouring::strain) return viridis(value / maximum);
    const double part = std::clamp(value / maximum, -1.0, 1.0);
    return mixed(palette.spring, part < 0 ? palette.compressed : palette.stretched, std::abs(part));
}

std::optional<ColourScale> colour_scale(const Frame& frame, const Style& style) {
    if (style.colouring == Colouring::role) return std::nullopt;
    // Without a largest value, as before the first motion, any scale will do.
    const double largest = largest_value(frame, style);
    const double maximum = style.scale_maximum.value_or(largest > 0 ? nice_ceil(largest, scale_digits) : 1.0);
    return ColourScale{style.colouring, style.colouring == Colouring::strain ? -maximum : 0.0, maximum};
}

std::string_view title(Colouring colouring) {
    constexpr std::array<std::string_view, 5> titles = {"", "speed [m/s]", "kinetic energy [J]", "displacement [m]",
                                                        "strain"};
    return titles[static_cast<std::size_t>(colouring)];
}

Rgb role_colour(const Style& style, Role role) {
    const Palette& colours = palette(style.background);
    const bool neutral = style.colouring == Colouring::strain && role == Role::moving;
    return neutral ? colours.neutral : colours.roles[static_cast<std::size_t>(role)];
}

Rgb particle_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i) {
    const Role role = frame.shape->roles[i];
    if (!scale || !shows_values(scale->colouring) || role == Role::fixed) return role_colour(style, role);
    return scale->colour(particle_value(frame, style, i), palette(style.background));
}

Rgb spring_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i) {
    const Palette& colours = palette(style.background);
    if (!scale || scale->colouring != Colouring::strain) return colours.spring;
    return scale->colour(strain(frame, frame.shape->springs[i]), colours);
}

}  // namespace steplab::render
