#include "render/particle_blocks.hpp"

#include "render/drawn_sizes.hpp"
#include "render/scenes.hpp"
#include "render/view_uniforms.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace steplab::render {
namespace {

const PictureSize size_of_blocks{320, 180};
const Tile whole{size_of_blocks};
constexpr std::size_t block = ParticleBlocks::block_size;

/// Blocks of particles, those of each block in a heap around one place.
Frame heaps_at(const std::vector<Vec3>& places) {
    std::vector<Vec3> positions;
    for (const Vec3& place : places) {
        for (std::size_t i = 0; i < block; ++i) {
            const double turn = 6.2832 * static_cast<double>(i) / block;
            positions.push_back(place + Vec3{0.1 * std::cos(turn), 0.1 * std::sin(turn), 0});
        }
    }
    return test::particles_at(positions);
}

std::vector<IndexRange> chosen(const Frame& frame, const Camera& camera, Detail detail, double radius = 0.05) {
    const Projection projection(camera, size_of_blocks);
    ParticleBlocks blocks;
    blocks.place(frame, projection);
    return blocks.choose(projection, whole, size_of_blocks, radius)[static_cast<std::size_t>(detail)];
}

std::size_t drawn(const Frame& frame, const Camera& camera, double radius = 0.05) {
    std::size_t sum = 0;
    for (const Detail detail : {Detail::dot, Detail::point, Detail::body}) {
        for (const IndexRange& range : chosen(frame, camera, detail, radius)) sum += range.count;
    }
    return sum;
}

const Camera front_view{{0, 0, 0}, 4, 0, 0};

TEST(ParticleBlocks, vertices_are_the_positions_in_their_order) {
    const Frame frame = heaps_at({{0, 0, 0}, {3, 1, -2}, {1e5, 0, 0}});
    const Projection projection({{1, 2, 3}, 7, 20, 30}, size_of_blocks);
    ParticleBlocks blocks;
    blocks.place(frame, projection);
    ASSERT_EQ(blocks.vertices().size(), frame.positions.size());
    for (std::size_t i = 0; i < frame.positions.size(); ++i)
        EXPECT_EQ(blocks.vertices()[i], vertex(projection, frame.positions[i])) << i;
    EXPECT_EQ(blocks.bounds(), bounds_of(frame.positions));
}

TEST(ParticleBlocks, nothing_outside_the_view_is_drawn) {
    // To the left and right, above and below, behind the eye; and one in the middle.
    const Frame frame = heaps_at({{-9, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, -9, 0}, {0, 0, 9}, {0, 0, 0}});
    EXPECT_THAT(chosen(frame, front_view, Detail::body), testing::ElementsAre(IndexRange{5 * block, block}));
    EXPECT_EQ(drawn(frame, front_view), block);
    EXPECT_EQ(drawn(frame, {{100, 0, 0}, 4, 0, 0}), 0u);
}

TEST(ParticleBlocks, what_straddles_the_border_is_drawn) {
    const double edge = 4 * Projection(front_view, size_of_blocks).half_width(),
                 high = 4 * Projection(front_view, size_of_blocks).half_height();
    for (const Vec3& place : {Vec3{edge, 0, 0}, Vec3{-edge, 0, 0}, Vec3{0, high, 0}, Vec3{0, -high, 0}}) {
        EXPECT_EQ(drawn(heaps_at({place}), front_view), block);
        // Outside by less than the radius of its balls, by a heap and more.
        EXPECT_EQ(drawn(heaps_at({1.1 * place}), front_view, 0.3), block);
        EXPECT_EQ(drawn(heaps_at({2 * place}), front_view, 0.3), 0u);
    }
    // A line of particles from far left to far right: none of the two ends is in the picture.
    std::vector<Vec3> line;
    for (std::size_t i = 0; i < block; ++i) line.push_back({static_cast<double>(i) - block / 2.0 + 0.5, 0, 0});
    EXPECT_EQ(drawn(test::particles_at(line), front_view), block);
}

TEST(ParticleBlocks, near_ones_are_bodies_far_ones_points_and_dots) {
    const Frame frame = heaps_at({{0, 0, 3}, {0, 0, 2}, {0, 0, -6}, {0, 0, -100}, {0, 0, -101}});
    EXPECT_THAT(chosen(frame, front_view, Detail::body), testing::ElementsAre(IndexRange{0, 2 * block}));
    EXPECT_THAT(chosen(frame, front_view, Detail::point), testing::ElementsAre(IndexRange{2 * block, block}));
    EXPECT_THAT(chosen(frame, front_view, Detail::dot), testing::ElementsAre(IndexRange{3 * block, 2 * block}));
    // Smaller ones show less.
    EXPECT_TRUE(chosen(frame, front_view, Detail::body, 1e-4).empty());
}

TEST(ParticleBlocks, a_block_partly_near_shows_all_that_there_is_to_see) {
    std::vector<Vec3> line;
    for (std::size_t i = 0; i < block; ++i) line.push_back({0, 0, 3 - static_cast<double>(i)});
    EXPECT_THAT(chosen(test::particles_at(line), front_view, Detail::body), testing::ElementsAre(IndexRange{0, block}));
}

TEST(ParticleBlocks, those_that_cannot_be_drawn_spoil_nothing) {
    Frame frame = heaps_at({{0, 0, 0}, {0, 0, 0}});
    const double infinite = std::numeric_limits<double>::infinity();
    frame.positions[3] = {0, std::nan(""), 0};
    frame.positions[5] = {1e120, 0, 0};
    for (std::size_t i = block; i < 2 * block; ++i) frame.positions[i] = {infinite, 0, 0};
    EXPECT_THAT(chosen(frame, front_view, Detail::body), testing::ElementsAre(IndexRange{0, block}));
    const Projection projection(front_view, size_of_blocks);
    ParticleBlocks blocks;
    blocks.place(frame, projection);
    const Vec3 eye = (1 / front_view.distance) * (projection.eye() - front_view.focus);
    for (const std::size_t hidden : {std::size_t{3}, std::size_t{5}, block})
        EXPECT_GT(static_cast<double>(blocks.vertices()[hidden].z), eye.z);
    EXPECT_LT(blocks.bounds().high.x, 0.2);
}

TEST(ParticleBlocks, tiles_share_what_the_picture_shows) {
    const Frame frame = heaps_at({{-1, 0, 0}, {1, 0, 0}});
    const Projection projection(front_view, size_of_blocks);
    ParticleBlocks blocks;
    blocks.place(frame, projection);
    const PictureSize half{160, 180};
    const auto body = static_cast<std::size_t>(Detail::body);
    EXPECT_THAT(blocks.choose(projection, {size_of_blocks, 0, 0}, half, 0.05)[body],
                testing::ElementsAre(IndexRange{0, block}));
    EXPECT_THAT(blocks.choose(projection, {size_of_blocks, 160, 0}, half, 0.05)[body],
                testing::ElementsAre(IndexRange{block, block}));
}

}  // namespace
}  // namespace steplab::render
