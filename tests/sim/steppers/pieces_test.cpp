#include "sim/steppers/pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace steplab::test {
namespace {

struct Cut {
    std::size_t particles, length, shared;
};
/// As of chains and grids, of scenes that are taken whole, and of few particles.
constexpr Cut cuts[] = {{1, 4, 1},  {4, 4, 1},  {5, 4, 1},  {6, 4, 1},  {97, 10, 1}, {91, 10, 1},
                        {90, 9, 3}, {93, 9, 3}, {12, 9, 3}, {15, 9, 3}, {60, 6, 6},  {66, 6, 6},
                        {40, 8, 0}, {41, 8, 0}, {7, 8, 0},  {0, 4, 1},  {64, 1, 1},  {64, 1, 0}};

/// A particle tells which one it is, and its velocity that it is no displacement.
State<double> numbered(std::size_t count) {
    State<double> state{Field<double>(count), Field<double>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const double number = static_cast<double>(i);
        state.displacement.set(i, {number, number + 0.25, number + 0.5});
        state.velocity.set(i, {-number, -number - 0.25, -number - 0.5});
    }
    return state;
}

/// What a sink hears of a piece.
struct Heard {
    std::size_t number, first, own, held;
    bool right;  ///< it holds the particles it says
    friend bool operator==(const Heard&, const Heard&) = default;
};
Heard heard(const Piece& piece) {
    bool right = true;
    for (std::size_t i = 0; i < piece.held; ++i) {
        const double number = static_cast<double>(piece.first + i);
        right = right && piece.state.displacement.at(i) == Vec3{number, number + 0.25, number + 0.5} &&
                piece.state.velocity.at(i) == Vec3{-number, -number - 0.25, -number - 0.5};
    }
    return {piece.number, piece.first, piece.own, piece.held, right};
}

/// Which there are to be, by the words of the declaration.
std::vector<Heard> expected(const Cut& cut) {
    std::vector<Heard> pieces;
    for (std::size_t first = 0; first < cut.particles; first += pieces.back().own) {
        const std::size_t left = cut.particles - first;
        const bool last = left <= cut.length + cut.shared;
        pieces.push_back({pieces.size(), first, last ? left : cut.length, last ? left : cut.length + cut.shared, true});
    }
    return pieces;
}

/// Numbers that cut so many particles into so many parts, some of which may be empty.
std::vector<std::size_t> borders(std::size_t particles, std::size_t parts, std::minstd_rand& random) {
    std::vector<std::size_t> all{0, particles};
    while (all.size() < parts + 1) all.push_back(random() % (particles + 1));
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Pieces, are_the_same_however_they_are_shown) {
    std::minstd_rand random;
    for (const Cut& cut : cuts) {
        const State<double> state = numbered(cut.particles);
        Pieces pieces(cut.particles, cut.length, cut.shared);
        const auto right = expected(cut);
        EXPECT_EQ(pieces.count(), std::max<std::size_t>(1, right.size()));
        for (int round = 0; round < 200; ++round) {
            const std::size_t parts = 1 + random() % 6;
            const auto part_ends = borders(cut.particles, parts, random);
            std::vector<Heard> found;
            const auto look = [&](const PortionSink& sink) {
                for (std::size_t part = parts; part-- > 0;) {  // the last one first: they come at the same time
                    const std::size_t begin = part_ends[part], count = part_ends[part + 1] - begin;
                    const auto ends = borders(count, 1 + random() % 4, random);
                    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                        if (ends[i] == ends[i + 1]) continue;
                        sink({begin + ends[i], ends[i + 1] - ends[i], state, begin + ends[i], part});
                    }
                }
            };
            pieces.each(parts, look, [&](const Piece& piece) { found.push_back(heard(piece)); });
            std::sort(found.begin(), found.end(), [](const Heard& a, const Heard& b) { return a.number < b.number; });
            ASSERT_EQ(found, right) << cut.particles << " " << cut.length << " " << cut.shared << " in " << parts;
        }
    }
}

}  // namespace
}  // namespace steplab::test
