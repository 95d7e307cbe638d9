#include "ui/panels/method_text.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string text(std::string_view model_id, std::string_view method_id, double fixed = 1) {
    RunDescription run = describe(model_id, method_id);
    if (run.scene.contains("fixed")) run.scene.set("fixed", fixed);
    return method_text(method(method_id).info, run.method_parameters, facts_of(run),
                       conservation(model(model_id).plan(run.scene)));
}

TEST(method_text, names_what_scene_and_method_keep) {
    EXPECT_EQ(text("morse", "rk4"), "order 4 · 4 force evaluations per step · conserves momentum");
    EXPECT_EQ(text("morse", "verlet"),
              "order 2 · 1 force evaluation per step · symplectic · time-reversible · conserves momentum, angular "
              "momentum · bounded energy error");
    EXPECT_EQ(text("chain", "rk4", 0), text("morse", "rk4"));
}

TEST(method_text, claims_nothing_that_the_scene_does_not_keep) {
    EXPECT_EQ(text("chain", "rk4"),
              "order 4 · 4 force evaluations per step · momentum changes in this scene (a fixed particle)");
    EXPECT_THAT(
        text("chain", "verlet"),
        HasSubstr(" · conserves angular momentum · bounded energy error · momentum changes in this scene (a fixed "
                  "particle)"));
    EXPECT_THAT(
        text("mesh", "verlet"),
        HasSubstr(" · bounded energy error · momentum and angular momentum change in this scene (fixed particles)"));
    EXPECT_THAT(text("crystal", "euler"), HasSubstr("conserves momentum"));
    EXPECT_THAT(text("crystal", "euler"),
                HasSubstr("angular momentum changes in this scene (periodic boundary conditions)"));
}

TEST(method_text, with_drag_says_nothing_of_energy) {
    for (const Method& entry : methods()) {
        const std::string shown = text("rope", entry.info.id);
        EXPECT_THAT(shown, Not(HasSubstr("energy"))) << entry.info.id;
        EXPECT_THAT(shown, Not(HasSubstr("conserves momentum"))) << entry.info.id;
    }
}

}  // namespace
}  // namespace steplab::ui
