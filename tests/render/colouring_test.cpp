#include "render/colouring.hpp"

#include "render/overlay.hpp"
#include "render/scenes.hpp"
#include "support/contrast.hpp"
#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace steplab::render {
namespace {

double luminance(Rgb c) { return test::luminance(c.red, c.green, c.blue); }

/// The scale of values at a part of it.
Rgb on_dark(double part) { return value_colour(part, palette(Background::dark)); }
Rgb on_light(double part) { return value_colour(part, palette(Background::light)); }

Style coloured_by(Colouring colouring) {
    Style style;
    style.colouring = colouring;
    return style;
}

TEST(ValueColours, go_from_blue_to_yellow_on_dark_and_from_violet_to_green_on_light) {
    EXPECT_EQ(on_dark(0), rgb(0x2e6e8e));
    EXPECT_EQ(on_dark(1), rgb(0xfde725));
    EXPECT_EQ(on_light(0), rgb(0x440154));
    EXPECT_EQ(on_light(1), rgb(0x20958c));
}

TEST(ValueColours, outside_the_scale_and_of_what_is_no_number_are_those_of_its_ends) {
    for (Rgb (*const colour)(double) : {on_dark, on_light}) {
        EXPECT_EQ(colour(-3), colour(0));
        EXPECT_EQ(colour(7), colour(1));
        EXPECT_EQ(colour(INFINITY), colour(1));
        EXPECT_EQ(colour(std::nan("")), colour(0));
    }
}

constexpr int shades = 1000;  // more than the levels of a channel: every colour of a scale is among them

TEST(ValueColours, stand_out_from_all_of_the_background) {
    ColourScale strain_scale;
    strain_scale.colouring = Colouring::strain;
    strain_scale.minimum = -1;
    strain_scale.maximum = 1;
    for (const Background background : {Background::dark, Background::light}) {
        const Palette& colours = palette(background);
        for (const Rgb ground : {colours.top, colours.bottom}) {
            for (int i = 0; i <= shades; ++i) {
                const double part = static_cast<double>(i) / shades;
                for (const Rgb colour : {value_colour(part, colours), strain_scale.colour(2 * part - 1, colours)}) {
                    ASSERT_GE(test::contrast(luminance(colour), luminance(ground)), test::of_shapes)
                        << id(background) << ", " << i;
                }
            }
        }
    }
}

TEST(ValueColours, become_lighter_all_the_way) {
    constexpr int steps = 50;  // so few that rounding of a channel, 1 of 255, never takes a step back
    for (Rgb (*const colour)(double) : {on_dark, on_light}) {
        for (double i = 0; i < steps; ++i)
            EXPECT_LT(luminance(colour(i / steps)), luminance(colour((i + 1) / steps))) << i;
    }
}

TEST(ValueColours, have_at_least_half_of_the_colour_map) {
    for (const Background background : {Background::dark, Background::light}) {
        const MapPart part = palette(background).values;
        EXPECT_GE(part.high - part.low, 0.5);
        EXPECT_TRUE(part.low >= 0 && part.high <= 1);
    }
}

TEST(ColourScale, ends_a_little_above_the_largest_value) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}});
    frame.velocities[1] = {0, 2.2, 0};
    const auto scale = colour_scale(frame, coloured_by(Colouring::speed));
    ASSERT_TRUE(scale);
    EXPECT_DOUBLE_EQ(scale->minimum, 0);
    EXPECT_DOUBLE_EQ(scale->maximum, 2.5);
}

Frame with_column(std::vector<double> values) {
    Frame frame = test::particles_at(std::vector<Vec3>(values.size()));
    frame.values = std::make_shared<const std::vector<ParticleValues>>(
        std::vector<ParticleValues>{{"q", {}}, {"c_pe", std::move(values)}});
    return frame;
}

Style coloured_by_column(std::string name) {
    Style style = coloured_by(Colouring::speed);
    style.column = std::move(name);
    return style;
}

/// But for the rounding of a channel.
void expect_near(Rgb a, Rgb b) {
    EXPECT_NEAR(a.red, b.red, 1);
    EXPECT_NEAR(a.green, b.green, 1);
    EXPECT_NEAR(a.blue, b.blue, 1);
}

TEST(ColourScale, of_a_column_ends_at_nice_numbers_around_its_values) {
    const Frame frame = with_column({-3.36, NAN, -2.9, INFINITY});
    const Style style = coloured_by_column("c_pe");
    const auto scale = colour_scale(frame, style);
    ASSERT_TRUE(scale);
    EXPECT_DOUBLE_EQ(scale->minimum, -3.4);
    EXPECT_DOUBLE_EQ(scale->maximum, -2.8);
    EXPECT_EQ(title(*scale), "c_pe");
    const Rgb neutral = palette(style.background).neutral;
    expect_near(particle_colour(frame, style, scale, 0), on_dark(0.04 / 0.6));
    EXPECT_EQ(particle_colour(frame, style, scale, 1), neutral) << "not a number";
    expect_near(particle_colour(frame, style, scale, 2), on_dark(0.5 / 0.6));
    EXPECT_EQ(particle_colour(frame, style, scale, 3), neutral);
}

TEST(ColourScale, of_a_column_that_a_frame_lacks_is_that_of_the_quantity) {
    const Frame frame = with_column({1, 2});
    EXPECT_EQ(title(*colour_scale(frame, coloured_by_column("c_ke"))), "speed [m/s]");
    EXPECT_EQ(title(*colour_scale(test::particles_at({{0, 0, 0}}), coloured_by_column("c_pe"))), "speed [m/s]");
    EXPECT_EQ(colour_word(frame, coloured_by_column("c_pe")), "column:c_pe");
    EXPECT_EQ(colour_word(frame, coloured_by_column("c_ke")), "speed");
    EXPECT_EQ(colour_word(frame, coloured_by_column("")), "speed");
}

/// Few marks along the scale, from its foot to its top, with different numbers that fit beside it.
void expect_a_legend(const ColourScale& scale) {
    const auto marks = legend_marks(scale);
    ASSERT_TRUE(!marks.empty() && marks.size() <= 6) << scale.minimum << " .. " << scale.maximum;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        ASSERT_TRUE(marks[i].part >= 0 && marks[i].part <= 1)
            << scale.minimum << " .. " << scale.maximum << ": " << marks[i].part << ", " << marks[i].text;
        ASSERT_LE(marks[i].text.size(), 24u) << marks[i].text;  // 17 digits, point, signs and exponent
        if (i == 0) continue;
        ASSERT_GT(marks[i].part, marks[i - 1].part) << scale.minimum << " .. " << scale.maximum;
        ASSERT_NE(marks[i].text, marks[i - 1].text) << scale.minimum << " .. " << scale.maximum;
    }
}

TEST(ColourScale, of_a_column_has_a_range_for_any_values) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        const Frame frame = with_column({a, b});
        const Style style = coloured_by_column("c_pe");
        const auto scale = colour_scale(frame, style);
        ASSERT_TRUE(scale->minimum < scale->maximum) << a << " " << b;
        expect_a_legend(*scale);
        particle_colour(frame, style, scale, 0);
        particle_colour(frame, style, scale, 1);
    }
}

TEST(ColourScale, has_an_end_and_a_colour_for_any_values) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        Frame frame = test::string_of({{0, 0, 0}, {1, 0, 0}});
        frame.positions[1] = {a, b, 0};
        frame.velocities[1] = {b, a, 0};
        for (const Colouring colouring :
             {Colouring::speed, Colouring::kinetic_energy, Colouring::displacement, Colouring::strain}) {
            const Style style = coloured_by(colouring);
            const auto scale = colour_scale(frame, style);
            ASSERT_TRUE(std::isfinite(scale->maximum) && scale->maximum > 0) << a << " " << b;
            expect_a_legend(*scale);
            particle_colour(frame, style, scale, 1);
            spring_colour(frame, style, scale, 0);
            for (const double value : special_doubles()) scale->colour(value, palette(style.background));
        }
    }
}

TEST(ColourScale, leaves_out_what_is_no_number) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    frame.velocities = {{0, 2.2, 0}, {INFINITY, 0, 0}, {0, std::nan(""), 0}};
    EXPECT_DOUBLE_EQ(colour_scale(frame, coloured_by(Colouring::speed))->maximum, 2.5);
}

TEST(ColourScale, can_be_given) {
    Style style = coloured_by(Colouring::speed);
    style.scale_maximum = 7;
    EXPECT_EQ(colour_scale(test::particles_at({{0, 0, 0}}), style)->maximum, 7);
}

TEST(ColourScale, there_is_none_of_roles) {
    EXPECT_FALSE(colour_scale(test::particles_at({{0, 0, 0}}), coloured_by(Colouring::role)));
}

TEST(ColourScale, of_strain_distinguishes_compressed_from_stretched) {
    Frame frame = test::string_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    frame.positions[1] = {1.2, 0, 0};  // first spring stretched, second compressed
    const Style style = coloured_by(Colouring::strain);
    const auto scale = colour_scale(frame, style);
    EXPECT_DOUBLE_EQ(scale->minimum, -scale->maximum);
    const Rgb stretched = spring_colour(frame, style, scale, 0), pressed = spring_colour(frame, style, scale, 1);
    EXPECT_GT(stretched.red, stretched.blue);
    EXPECT_GT(pressed.blue, pressed.red);
}

TEST(ParticleColours, fixed_ones_stay_grey_whatever_is_shown) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}}, {Role::fixed, Role::moving});
    frame.velocities[1] = {1, 0, 0};
    for (const Colouring colouring :
         {Colouring::role, Colouring::speed, Colouring::kinetic_energy, Colouring::displacement, Colouring::strain}) {
        const Style style = coloured_by(colouring);
        const Rgb colour = particle_colour(frame, style, colour_scale(frame, style), 0);
        EXPECT_EQ(colour, palette(Background::dark).roles[static_cast<std::size_t>(Role::fixed)]);
    }
}

TEST(ParticleColours, follow_the_value) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    frame.velocities[1] = {0, 1, 0};
    frame.positions[2] = {2, 1, 0};
    Style style = coloured_by(Colouring::speed);
    const auto colour = [&](std::size_t i) { return particle_colour(frame, style, colour_scale(frame, style), i); };
    EXPECT_EQ(colour(0), on_dark(0));
    EXPECT_EQ(colour(1), on_dark(1));
    style = coloured_by(Colouring::displacement);
    EXPECT_EQ(colour(1), on_dark(0));
    EXPECT_EQ(colour(2), on_dark(1));
}

TEST(ParticleColours, kinetic_energy_takes_the_mass) {
    Frame frame = test::particles_at({{0, 0, 0}});
    frame.velocities[0] = {2, 0, 0};
    Style style = coloured_by(Colouring::kinetic_energy);
    style.mass = 3;
    EXPECT_DOUBLE_EQ(colour_scale(frame, style)->maximum, 6);
}

TEST(Palettes, roles_have_distinct_colours) {
    for (const Background background : {Background::dark, Background::light}) {
        const auto& roles = palette(background).roles;
        for (std::size_t a = 0; a < roles.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) EXPECT_NE(roles[a], roles[b]);
        }
    }
}

}  // namespace
}  // namespace steplab::render
