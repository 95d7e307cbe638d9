#include "core/error.hpp"
#include "render/drawn_sizes.hpp"
#include "render/scenes.hpp"
#include "render/studio.hpp"
#include "sim/run/simulation.hpp"

#include <gmock/gmock.h>

namespace steplab::render {
namespace {

using test::bare;
using test::difference;
using test::differing_pixels;
using test::Image;

/// Clearly not the background: its gradient stays far below this.
constexpr int visible = 40;

const PictureSize picture_size{320, 180};
const Camera frontal{{0, 0, 0}, 4, 0, 0};

PixelPoint frontal_place_of(Vec3 point, const Camera& camera = frontal) {
    return *Projection(camera, picture_size).pixel(point);
}

class Picture : public test::Studio {
protected:
    static Image empty(const Style& style = bare()) { return draw(test::particles_at({{0, 0, 100}}), frontal, style); }
};

TEST_F(Picture, of_nothing_is_the_background_alone) {
    const Image image = empty();
    for (int x : {0, 160, 319}) EXPECT_LT(difference(image.at(x, 90), image.at(0, 90)), 1);
    EXPECT_NE(image.at(0, 0), image.at(0, 179));  // it is shaded
}

TEST_F(Picture, shows_a_particle_where_it_is_and_nowhere_else) {
    const Image image = draw(test::particles_at({{0.5, 0.3, 0}}), frontal, bare());
    const Image background = empty();
    const PixelPoint place = frontal_place_of({0.5, 0.3, 0});
    EXPECT_GT(difference(image.at(place), background.at(place)), visible);
    const PixelPoint mirrored = frontal_place_of({-0.5, 0.3, 0});
    EXPECT_EQ(image.at(mirrored), background.at(mirrored));
}

TEST_F(Picture, of_a_periodic_scene_is_the_same_after_whole_periods) {
    Style style = bare();
    style.selected = 1;
    const auto moved = [&](Vec3 by) {
        return draw(test::periodic({{0.5, 0.25, 0}, Vec3{-0.5, 0.25, 0.5} + by}, 2, {-1, -1, -1}), frontal, style).rgba;
    };
    EXPECT_EQ(moved({6, -2, 4}), moved({0, 0, 0}));
    EXPECT_NE(moved({1, 0, 0}), moved({0, 0, 0})) << "by half a period";
}

TEST_F(Picture, ball_has_the_size_of_its_radius) {
    const Frame frame = test::particles_at({{0, 0, 0}});
    const int area = differing_pixels(draw(frame, frontal, bare()), empty(), 8);
    const double radius =
        DrawnSizes(*frame.shape).radius(Role::moving) * Projection(frontal, picture_size).pixels_per_unit(4);
    // The outline is half covered pixels, about 2 pi r of them.
    EXPECT_NEAR(area, 3.1416 * radius * radius, 6.3 * radius);
}

TEST_F(Picture, balls_in_front_hide_those_behind) {
    Frame frame = test::particles_at({{0, 0, 1}, {0, 0, -1}}, {Role::moving, Role::kicked});
    const PixelPoint centre = frontal_place_of({0, 0, 0});
    const Image front_first = draw(frame, frontal, bare());
    std::swap(frame.positions[0], frame.positions[1]);
    const Image other_in_front = draw(frame, frontal, bare());
    EXPECT_GT(front_first.at(centre).blue, front_first.at(centre).red);
    EXPECT_GT(other_in_front.at(centre).red, other_in_front.at(centre).blue);
}

TEST_F(Picture, balls_that_cross_share_the_picture_by_depth) {
    // The left half of each is nearer by half a radius than the other's right half.
    const Image image =
        draw(test::particles_at({{-0.1, 0, 0}, {0.1, 0, 0}}, {Role::moving, Role::kicked}), frontal, bare());
    const Rgb left = image.at(frontal_place_of({-0.15, 0, 0}));
    const Rgb right = image.at(frontal_place_of({0.15, 0, 0}));
    EXPECT_GT(left.blue, left.red);
    EXPECT_GT(right.red, right.blue);
}

TEST_F(Picture, outlines_are_smooth) {
    const Image image = draw(test::particles_at({{0, 0, 0}}), frontal, bare());
    const Image background = empty();
    const Rgb inside = image.at(frontal_place_of({0, 0, 0}));
    const double edge = DrawnSizes(*test::particles_at({{0, 0, 0}}).shape).radius(Role::moving);
    int between = 0;
    for (int angle = 0; angle < 64; ++angle) {
        const double turn = angle * 6.2832 / 64;
        // A ball's outline lies a little outside its radius in perspective.
        const Rgb colour =
            image.at(frontal_place_of({1.001 * edge * std::cos(turn), 1.001 * edge * std::sin(turn), 0}));
        between += colour.blue > background.at(160, 90).blue + 12 && colour.blue < inside.blue - 12;
    }
    EXPECT_GT(between, 16);
}

TEST_F(Picture, named_particle_has_its_colour) {
    Frame frame = test::particles_at({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {Role::moving, Role::kicked, Role::bullet});
    const Image image = draw(frame, frontal, bare());
    const auto colour = [&](std::size_t i) { return image.at(frontal_place_of(frame.positions[i])); };
    EXPECT_GT(colour(0).blue, colour(0).red + visible);  // blue
    EXPECT_GT(colour(1).red, colour(1).blue + visible);  // amber
    EXPECT_GT(colour(1).green, colour(1).blue + visible);
    EXPECT_GT(colour(2).red, colour(2).green + visible);  // red
}

TEST_F(Picture, colours_follow_the_speed) {
    Frame frame = test::particles_at({{-1, 0, 0}, {1, 0, 0}});
    frame.velocities[1] = {0, 3, 0};
    Style style = bare();
    style.colouring = Colouring::speed;
    const Image image = draw(frame, frontal, style);
    const Rgb slow = image.at(frontal_place_of({-1, 0, 0}));
    const Rgb fast = image.at(frontal_place_of({1, 0, 0}));
    EXPECT_GT(slow.blue, slow.green);            // purple
    EXPECT_GT(fast.green, fast.blue + visible);  // yellow
}

TEST_F(Picture, fixed_particle_and_bullet_have_shapes_of_their_own) {
    const Camera slanted{{0, 0, 0}, 2, 30, 25};
    std::vector<int> areas;
    for (const Role role : {Role::moving, Role::fixed, Role::bullet}) {
        const Image image = draw(test::particles_at({{0, 0, 0}}, {role}), slanted, bare());
        const DrawnSizes drawn(*test::particles_at({{0, 0, 0}}, {role}).shape);
        const double radius = drawn.radius(role) * Projection(slanted, picture_size).pixels_per_unit(2);
        areas.push_back(static_cast<int>(100 * differing_pixels(image, empty(), 8) / (3.1416 * radius * radius)));
    }
    // Of the disc of their ball, a cube and an octahedron with their corners on it cover clearly less.
    EXPECT_GT(areas[0], 95);
    EXPECT_LT(areas[1], 85);
    EXPECT_LT(areas[2], 75);
}

TEST_F(Picture, kicked_particle_has_a_ring) {
    const double radius = DrawnSizes(*test::particles_at({{0, 0, 0}}).shape).radius(Role::kicked);
    const auto ring_drawn = [&](Role role) {
        const Image image = draw(test::particles_at({{0, 0, 0}}, {role}), frontal, bare());
        return differing_pixels(image, empty(), 8) > 1.2 * 3.1416 * std::pow(radius * 90 / (4 * 0.2493), 2);
    };
    EXPECT_TRUE(ring_drawn(Role::kicked));
    EXPECT_FALSE(ring_drawn(Role::moving));
}

TEST_F(Picture, selected_particle_is_marked_even_behind_others) {
    Style style = bare();
    const Frame frame = test::particles_at({{0, 0, 1}, {0, 0, 0}});
    const Image without = draw(frame, frontal, style);
    style.selected = 1;
    EXPECT_GT(differing_pixels(draw(frame, frontal, style), without, visible), 20);
    style.selected = 99;  // a particle that is not there
    EXPECT_EQ(differing_pixels(draw(frame, frontal, style), without), 0);
}

TEST_F(Picture, springs_are_drawn_where_wanted) {
    const Frame frame = test::string_of({{-1, 0, 0}, {1, 0, 0}});
    Style style = bare();
    const PixelPoint middle = frontal_place_of({0, 0, 0});
    EXPECT_EQ(draw(frame, frontal, style).at(middle), empty().at(middle));
    style.springs = true;
    EXPECT_GT(difference(draw(frame, frontal, style).at(middle), empty().at(middle)), visible);
}

TEST_F(Picture, grid_and_axes_are_drawn_where_wanted) {
    Style style = bare();
    const Frame frame = test::particles_at({{0, 0, 0}, {3, 0, 3}});
    const Camera camera = default_camera(frame, picture_size);
    const Image without = draw(frame, camera, style);
    style.grid = true;
    EXPECT_GT(differing_pixels(draw(frame, camera, style), without, 8), 500);
}

TEST_F(Picture, grid_does_not_cover_particles_above_it) {
    Style style = bare();
    const Frame frame = test::particles_at({{0, 0, 0}, {3, 0, 3}});
    const Camera camera = default_camera(frame, picture_size);
    const PixelPoint place = frontal_place_of({3, 0, 3}, camera);
    const Rgb without = draw(frame, camera, style).at(place);
    style.grid = true;
    EXPECT_EQ(draw(frame, camera, style).at(place), without);
}

TEST_F(Picture, legend_is_drawn_at_the_upper_right_where_wanted) {
    Style style = bare();
    style.colouring = Colouring::speed;
    const Frame frame = test::particles_at({{0, 0, 0}});
    const Image without = draw(frame, frontal, style);
    style.legend = true;
    const Image with = draw(frame, frontal, style);
    EXPECT_GT(differing_pixels(with, without, 8), 200);
    EXPECT_EQ(with.at(10, 170), without.at(10, 170));
}

TEST_F(Picture, background_is_dark_or_light) {
    Style style = bare();
    EXPECT_LT(empty(style).at(0, 0).green, 60);
    style.background = Background::light;
    EXPECT_GT(empty(style).at(0, 0).green, 200);
}

TEST_F(Picture, changes_after_steps_and_not_without) {
    Simulation simulation(describe("mesh"));
    const Camera camera = default_camera(simulation.frame(), picture_size);
    const Image start = draw(simulation.frame(), camera);
    EXPECT_EQ(differing_pixels(draw(simulation.frame(), camera), start), 0);
    simulation.advance(20);
    EXPECT_GT(differing_pixels(draw(simulation.frame(), camera), start, visible), 10);
}

TEST_F(Picture, same_frame_gives_the_same_bytes) {
    Simulation simulation(describe("morse"));
    simulation.advance(50);
    const Image once = draw(simulation.frame());
    draw(test::particles_at({{0, 0, 0}}));  // something else in between
    EXPECT_EQ(draw(simulation.frame()).rgba, once.rgba);
}

TEST_F(Picture, tiles_make_up_the_whole) {
    Simulation simulation(describe("mesh"));
    const Camera camera = default_camera(simulation.frame(), picture_size);
    const Image whole = draw(simulation.frame(), camera);
    int differing = 0;
    for (const Tile& tile : {Tile{picture_size, 0, 0}, Tile{picture_size, 160, 0}, Tile{picture_size, 0, 90},
                             Tile{picture_size, 160, 90}}) {
        const RenderTarget target({160, 90});
        renderer().draw(simulation.frame(), {}, camera, target, tile);
        const Image part{{160, 90}, target.read()};
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 160; ++x)
                differing += difference(part.at(x, y), whole.at(tile.left + x, tile.top + y)) > 8;
        }
    }
    // Outlines may fall on the other side of a sample by rounding.
    EXPECT_LT(differing, 320 * 180 / 500);
}

TEST_F(Picture, far_from_the_origin_is_as_sharp) {
    const Vec3 far{1e9, -2e9, 3e9};
    Frame near_frame = test::particles_at({{0, 0, 0}, {0.5, 0, 0}});
    Frame far_frame = test::particles_at({far, far + Vec3{0.5, 0, 0}});
    const Image a = draw(near_frame, frontal, bare());
    const Image b = draw(far_frame, {far, 4, 0, 0}, bare());
    // Positions are multiples of 2^-22 there, far below a pixel; outlines may fall on the other side of a sample.
    EXPECT_LT(differing_pixels(a, b, 8), 20);
}

TEST_F(Picture, scale_of_the_scene_does_not_matter) {
    const auto scaled = [](double s) {
        Frame frame = test::particles_at({{0, 0, 0}, {0.5 * s, 0, 0}});
        auto shape = std::make_shared<Shape>(*frame.shape);
        shape->spacing = s;
        frame.shape = shape;
        return draw(frame, {{0, 0, 0}, 4 * s, 0, 0}, bare());
    };
    const Image usual = scaled(1);
    for (const double s : {0x1p-80, 0x1p-20, 0x1p20, 0x1p80}) EXPECT_EQ(scaled(s).rgba, usual.rgba) << s;
}

TEST_F(Picture, every_size_can_be_drawn) {
    Simulation simulation(describe("rope"));
    for (const PictureSize each : {PictureSize{1, 1}, {400, 300}, {3840, 2160}, {1, 500}}) {
        const Image image = draw(simulation.frame(), {}, each);
        EXPECT_EQ(image.rgba.size(), 4u * static_cast<unsigned>(each.width * each.height));
    }
}

TEST_F(Picture, too_large_a_one_is_refused_with_the_largest_size) {
    try {
        const RenderTarget target({1 << 20, 10});
        ADD_FAILURE() << "a picture a million pixels wide was made";
    } catch (const GraphicsError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("1048576x10"));
    }
}

TEST_F(Picture, of_a_million_particles_shows_them_all_over) {
    RunDescription description = describe("mesh");
    description.scene.set("dim", 1000);
    const Frame frame = Simulation(description).frame();
    const Camera camera = default_camera(frame, picture_size);
    const Image image = draw(frame, camera, bare());
    const Image background = draw(test::particles_at({{0, 0, 1e6}}), frontal, bare());
    for (const std::size_t i : {250'250u, 500'400u, 750'750u, 300'700u}) {
        const PixelPoint place = frontal_place_of(frame.positions[i], camera);
        EXPECT_GT(difference(image.at(place), background.at(place)), visible) << i;
    }
}

TEST_F(Picture, small_balls_become_points_without_a_jump) {
    // Just above and just below the size at which a ball is drawn as a point.
    const Frame frame = test::particles_at({{0, 0, 0}});
    const double radius = DrawnSizes(*frame.shape).radius(Role::moving);
    const auto brightness = [&](double pixels) {
        const double distance = radius * Projection({{0, 0, 0}, 1, 0, 0}, picture_size).pixels_per_unit(1) / pixels;
        const Image image = draw(frame, {{0, 0, 0}, distance, 0, 0}, bare());
        int sum = 0;
        for (int y = 80; y < 100; ++y) {
            for (int x = 150; x < 170; ++x) sum += image.at(x, y).blue;
        }
        return sum;
    };
    EXPECT_NEAR(brightness(3.499), brightness(3.501), 0.1 * brightness(3.5));
}

}  // namespace
}  // namespace steplab::render
