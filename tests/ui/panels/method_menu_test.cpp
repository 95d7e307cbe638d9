// Methods that cannot run a scene: which they are, and that the menu offers none of them.
#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/asked.hpp"
#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::ui {
namespace {

TEST(method_menu, reasons_are_those_for_which_a_run_is_refused) {
    std::size_t refused = 0;
    for (const std::string& name : shipped_scenes()) {
        const RunDescription run = describe(find_scene(name));
        const auto refusals = Simulation(run).refusals();
        for (const Method& method : methods()) {
            const auto known = refusals->find(method.info.id);
            const auto right = test::refusal_of(with_method(run, method.info.id));
            EXPECT_EQ(known != refusals->end(), right.has_value()) << name << ' ' << method.info.id;
            if (known == refusals->end() || !right) continue;
            EXPECT_EQ(known->second, *right);
            ++refused;
        }
    }
    EXPECT_GT(refused, 20U) << "the 2008 ones alone are refused by most of them";
}

TEST(method_menu, what_cannot_run_the_scene_cannot_be_chosen) {
    const RunDescription cradle = describe(find_scene("newtons-cradle"));
    Desk desk(cradle);
    desk.show(view_of(Simulation(cradle)));
    desk.click("method");
    desk.calls();
    for (const char* const refused : {"method/taylor", "method/verlet-2008", "method/stoermer-2008"}) {
        desk.click(refused);
        EXPECT_TRUE(desk.calls().empty()) << refused;
        EXPECT_TRUE(desk.has("method/rk4")) << "the menu stays open: " << refused;
    }
    desk.click("method/rk4");
    ASSERT_FALSE(desk.recorder.changes.empty());
    EXPECT_EQ(desk.wanted().method, "rk4");
}

}  // namespace
}  // namespace steplab::ui
