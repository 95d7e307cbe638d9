// What was given last to ranges of numbers, against a list of all of them.
#include "models/scene/scene_particles.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace steplab {
namespace {

TEST(LastGiven, is_what_a_list_of_all_holds) {
    std::mt19937 random(2008);
    std::uniform_int_distribution<std::size_t> place(0, 40);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<int> values(60);
        for (int i = 0; i < 60; ++i) values[static_cast<std::size_t>(i)] = i;
        std::vector<const int*> all(90, nullptr);
        LastGiven<int> given;
        for (const int& value : values) {
            const IndexRange range{place(random), place(random) % 20};
            given.give(range, value);
            for (std::size_t i = range.first; i < range.first + range.count; ++i) all[i] = &value;
            for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(given.at(i), all[i]) << trial << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace steplab
