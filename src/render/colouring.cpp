#include "render/colouring.hpp"

#include "core/clamped.hpp"
#include "core/shown.hpp"
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
        return static_cast<std::uint8_t>(clamped_floor(from + part * (to - from) + 0.5, 0, 255));
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// The colour map at 0 .. 1.
Rgb viridis(double part) {
    constexpr int last = static_cast<int>(viridis_stops.size()) - 1;
    const double place = part * last;
    const auto lower = static_cast<std::size_t>(clamped_floor(place, 0, last - 1));
    return mixed(viridis_stops[lower], viridis_stops[lower + 1], place - static_cast<double>(lower));
}

/// Length of a vector between points that are drawable().
double size_of(Vec3 v) { return std::sqrt(dot(v, v)); }

/// Distinct with every kind of colour blindness (M. Okabe and K. Ito, 2008), without black; more groups take turns.
Rgb group_colour(std::size_t group) {
    constexpr std::array<Rgb, 7> colours = {rgb(0x56b4e9), rgb(0xe69f00), rgb(0x009e73), rgb(0xcc79a7),
                                            rgb(0xf0e442), rgb(0xd55e00), rgb(0x0072b2)};
    return colours[group % colours.size()];
}

double particle_value(const Frame& frame, const Style& style, std::size_t i) {
    switch (style.colouring) {
        case Colouring::speed:
            return size_of(frame.velocities[i]);
        case Colouring::kinetic_energy:
            return 0.5 * (frame.shape->masses.empty() ? style.mass : frame.shape->masses[i]) *
                   dot(frame.velocities[i], frame.velocities[i]);
        default:
            return size_of(frame.positions[i] - frame.shape->rest[i]);
    }
}

double strain(const Frame& frame, const Spring& spring) {
    const double now = size_of(frame.nearest(frame.positions[spring.second] - frame.positions[spring.first]));
    // A spring without rest length has no strain: its length is the measure of its extension.
    return spring.rest_length > 0 ? now / spring.rest_length - 1 : now;
}

// Leading digits of the ends of colour scales: closer to each other than those of ticks.
constexpr double scale_digits[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};

/// Of the values that are numbers: others are left out, as where a run blows up.
double largest_value(const Frame& frame, const Style& style) {
    double largest = 0;
    const auto include = [&largest](double value) {
        if (std::isfinite(value)) largest = std::max(largest, value);
    };
    if (style.colouring == Colouring::strain) {
        for (const Spring& spring : frame.shape->springs) include(std::abs(strain(frame, spring)));
    } else {
        for (std::size_t i = 0; i < frame.positions.size(); ++i) {
            include(particle_value(frame, style, i));
        }
    }
    return largest;
}

/// From below its smallest number to above its largest one.
ColourScale scale_of(const ParticleValues& column) {
    constexpr int parts = 4;
    double low = INFINITY, high = -INFINITY;
    for (const double value : column.values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const Range range = nice_range(low, high, parts);
    return {.minimum = range.low, .maximum = range.high, .column = &column};
}

}  // namespace

Rgb value_colour(double part, const Palette& palette) {
    const double inside = part > 0 ? std::min(part, 1.0) : 0;  // what is no number has the colour of 0
    return viridis(std::lerp(palette.values.low, palette.values.high, inside));
}

Rgb ColourScale::colour(double value, const Palette& palette) const {
    if (column) return value_colour(part_between(minimum, maximum, value), palette);
    if (colouring != Colouring::strain) return value_colour(value / maximum, palette);
    const double quotient = value / maximum;
    const double part = std::isnan(quotient) ? 0 : std::clamp(quotient, -1.0, 1.0);
    return mixed(palette.unstrained, part < 0 ? palette.compressed : palette.stretched, std::abs(part));
}

const ParticleValues* shown_column(const Frame& frame, const Style& style) {
    if (style.column.empty() || !frame.values) return nullptr;
    const auto found = std::find_if(frame.values->begin(), frame.values->end(),
                                    [&](const ParticleValues& column) { return column.name == style.column; });
    return found == frame.values->end() ? nullptr : &*found;
}

std::string colour_word(const Frame& frame, const Style& style) {
    const bool by_column = shown_column(frame, style) != nullptr;
    return by_column ? std::string(column_prefix) + style.column : std::string(id(style.colouring));
}

std::optional<ColourScale> colour_scale(const Frame& frame, const Style& style) {
    if (const ParticleValues* const column = shown_column(frame, style)) return scale_of(*column);
    if (style.colouring == Colouring::role || style.colouring == Colouring::group) return std::nullopt;
    // Without a largest value, as before the first motion, any scale will do.
    const double largest = largest_value(frame, style);
    const double nice = nice_ceil(largest, scale_digits);
    const double end = std::isfinite(nice) ? nice : largest;
    const double maximum = style.scale_maximum.value_or(largest > 0 ? end : 1.0);
    return ColourScale{.colouring = style.colouring,
                       .minimum = style.colouring == Colouring::strain ? -maximum : 0.0,
                       .maximum = maximum};
}

std::string title(const ColourScale& scale) {
    constexpr std::size_t most = 24;
    if (scale.column) return shown(scale.column->name, most);
    constexpr std::array<std::string_view, 6> titles = {
        "", "speed [m/s]", "kinetic energy [J]", "displacement [m]", "strain", ""};
    return std::string(titles[static_cast<std::size_t>(scale.colouring)]);
}

Rgb role_colour(const Style& style, Role role) {
    const Palette& colours = palette(style.background);
    const bool neutral = style.colouring == Colouring::strain && role == Role::moving;
    if (neutral) return colours.neutral;
    const bool of_run = style.swatch > 0 && role == Role::moving;
    return of_run ? colours.runs[style.swatch] : colours.roles[static_cast<std::size_t>(role)];
}

Rgb particle_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i) {
    const Role role = frame.shape->roles[i];
    if (scale && scale->column) {
        const double value = scale->column->values[i];
        const Palette& colours = palette(style.background);
        return std::isfinite(value) ? scale->colour(value, colours) : colours.neutral;
    }
    if (style.colouring == Colouring::group && role != Role::fixed && !frame.shape->groups.empty())
        return group_colour(frame.shape->groups[i]);
    if (!scale || !shows_values(scale->colouring) || role == Role::fixed) return role_colour(style, role);
    return scale->colour(particle_value(frame, style, i), palette(style.background));
}

Rgb spring_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i) {
    const Palette& colours = palette(style.background);
    if (!scale || scale->column || scale->colouring != Colouring::strain) return colours.spring;
    return scale->colour(strain(frame, frame.shape->springs[i]), colours);
}

}  // namespace steplab::render
