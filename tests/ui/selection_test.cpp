#include "ui/selection.hpp"

#include "sim/catalogue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace steplab::ui {
namespace {

RunView view_with(const std::vector<Alteration>& alterations) {
    return view_of(Simulation(with_alterations(describe("chain"), alterations)));
}

TEST(usual_mass, is_that_of_the_particles_that_are_not_altered) {
    EXPECT_EQ(usual_mass(view_with({}), 7), 1);
    EXPECT_EQ(usual_mass(view_with({{4, true}}), 7), 1);
    EXPECT_EQ(usual_mass(view_with({{4, std::nullopt, 3.0}}), 7), 1);
    EXPECT_EQ(usual_mass(view_with({{0, std::nullopt, 2.0}, {4, std::nullopt, 3.0}, {9, std::nullopt, 1.0}}), 7), 1);
}

TEST(usual_mass, is_none_where_the_scene_has_several) {
    RunView view = view_with({{4, std::nullopt, 3.0}});
    view.description.alterations = {};
    EXPECT_EQ(usual_mass(view, 7), 7) << "the scene itself has two masses";
    std::vector<Alteration> all;
    for (std::size_t i = 0; i < 10; ++i) all.push_back({i, std::nullopt, i == 3 ? 2.0 : 5.0});
    EXPECT_EQ(usual_mass(view_with(all), 7), 7) << "all of them are altered";
}

}  // namespace
}  // namespace steplab::ui
