#include "sim/ensemble/live_ensemble.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace steplab::ui {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// The panel beside a run that has this cloud.
class CloudPanel : public testing::Test {
protected:
    void show(const Cloud& cloud) {
        desk.view.cloud = cloud;
        desk.view.frame.cloud.clear();
        for (std::size_t i = 0; i < cloud.runs; ++i)
            desk.view.frame.cloud.insert(desk.view.frame.cloud.end(), desk.view.frame.positions.begin(),
                                         desk.view.frame.positions.end());
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        desk.calls();
    }
    const Cloud& asked() const { return desk.recorder.clouds.back(); }

    Desk desk{describe("morse")};
};

TEST_F(CloudPanel, is_one_row_until_there_is_a_cloud) {
    EXPECT_TRUE(desk.has("cloud/off"));
    EXPECT_FALSE(desk.has("cloud spread"));
    EXPECT_FALSE(desk.has("cloud width"));
    desk.click("cloud/off");
    EXPECT_THAT(desk.calls(), Not(Contains("cloud")));
    show({.runs = 16});
    EXPECT_TRUE(desk.has("cloud spread"));
    EXPECT_TRUE(desk.has("cloud width"));
}

TEST_F(CloudPanel, switches_it_on_and_off) {
    desk.click("cloud/64");
    EXPECT_THAT(desk.calls(), Contains("cloud"));
    EXPECT_EQ(asked(), Cloud{.runs = 64});
    EXPECT_TRUE(desk.has("cloud spread")) << "it answers before the run does";
    show({.runs = 64});
    desk.click("cloud/off");
    EXPECT_EQ(asked().runs, 0u);
}

TEST_F(CloudPanel, chooses_what_differs) {
    show({.runs = 16, .spread = "v0"});
    desk.click("cloud spread");
    desk.click("cloud spread/spacing");
    EXPECT_EQ(asked(), (Cloud{.runs = 16, .spread = "spacing"}));
    EXPECT_FALSE(desk.has("cloud spread/edge")) << "particles cannot come and go";
}

TEST_F(CloudPanel, takes_its_width_typed_and_dragged) {
    show({.runs = 16});
    desk.click("cloud width.value");
    desk.type("0.0125");
    desk.key(Key::enter);
    EXPECT_EQ(asked().width, 0.0125);
    const std::size_t before = desk.recorder.clouds.size();
    desk.click("cloud width.value");
    desk.type("0.7");
    desk.key(Key::enter);
    EXPECT_EQ(desk.recorder.clouds.size(), before) << "beyond half the value";
    desk.drag("cloud width", 0.5f, 0.2f);
    EXPECT_GT(desk.recorder.clouds.size(), before);
    EXPECT_LT(asked().width, 1e-9);
}

TEST_F(CloudPanel, shows_what_there_is_once_a_cloud_is_refused) {
    for (int attempt = 0; attempt < 2; ++attempt) {
        desk.click("cloud/64");
        desk.frame();
        EXPECT_TRUE(desk.has("cloud spread")) << "it was asked for, no answer yet";
        // A run that stands sends the one view that tells why.
        desk.view.error = "a cloud of 64 runs is too large";
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        EXPECT_FALSE(desk.has("cloud spread")) << "the run goes on without";
    }
}

TEST_F(CloudPanel, tells_nothing_of_a_spread_that_it_could_not_be_asked_for) {
    show({.runs = 16, .otherwise = true});
    EXPECT_TRUE(desk.has("cloud/off"));
    EXPECT_FALSE(desk.has("cloud spread"));
    EXPECT_FALSE(desk.has("cloud width"));
}

TEST_F(CloudPanel, keeps_the_run_as_it_is) {
    show({.runs = 16});
    desk.drag("cloud width", 0.5f, 0.2f);
    EXPECT_THAT(desk.recorder.changes, IsEmpty());
}

}  // namespace
}  // namespace steplab::ui
