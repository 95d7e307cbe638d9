#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

using testing::IsEmpty;

Divergence blow_up(std::uint64_t step) {
    Divergence divergence;
    divergence.step = step;
    divergence.message = "the energy grew without bound";
    return divergence;
}

/// A desk with messages of every kind over the scene: a run that diverged, one refusal, help.
struct Crowded {
    Crowded() : desk(describe("chain")) {
        desk.view.divergence = blow_up(12);
        desk.interface.record(desk.view);
        desk.interface.report_error("no");
        desk.key(Key::f1);
    }
    Desk desk;
};

TEST(escape, closes_one_message_at_a_time_from_the_top) {
    Crowded crowded;
    Desk& desk = crowded.desk;
    for (const char* card : {"help", "refusal", "divergence"}) {
        ASSERT_TRUE(desk.has(card));
        desk.key(Key::escape);
        EXPECT_FALSE(desk.has(card)) << card;
    }
    desk.key(Key::escape);
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(escape, closes_a_notice) {
    Desk desk;
    desk.interface.notify("saved");
    desk.frame();
    ASSERT_TRUE(desk.has("notice"));
    desk.key(Key::escape);
    EXPECT_FALSE(desk.has("notice"));
}

TEST(escape, closes_the_card_of_a_lost_camera_until_it_is_lost_again) {
    Desk desk(describe("chain"));
    const render::Camera start = desk.camera, away{{1e4, 0, 0}, 20, 0, 0};
    const auto move = [&](const render::Camera& camera) {
        desk.camera = camera;
        desk.frame();
        desk.frame();
    };
    move(away);
    ASSERT_TRUE(desk.has("lost"));
    desk.key(Key::escape);
    EXPECT_FALSE(desk.has("lost"));
    move(start);
    move(away);
    EXPECT_TRUE(desk.has("lost"));
}

TEST(escape, closes_menus_and_drop_downs_before_messages) {
    const std::pair<const char*, const char*> menus[] = {{"menu", "menu/quit"},
                                                         {"model", "model/chain"},
                                                         {"method", "method/rk4"},
                                                         {"colouring", "colouring/speed"},
                                                         {"energy error.save", "energy error.csv"}};
    for (const auto& [button, item] : menus) {
        Crowded crowded;
        Desk& desk = crowded.desk;
        desk.key(Key::escape);
        desk.key(Key::escape);
        desk.click(button);
        ASSERT_TRUE(desk.has(item)) << button;
        desk.key(Key::escape);
        EXPECT_FALSE(desk.has(item)) << button;
        EXPECT_TRUE(desk.has("divergence")) << button;
        desk.key(Key::escape);
        EXPECT_FALSE(desk.has("divergence")) << button;
        EXPECT_THAT(desk.recorder.changes, IsEmpty());
    }
}

TEST(escape, that_closes_a_card_lets_the_next_divergence_be_shown) {
    Desk desk;
    desk.view.divergence = blow_up(12);
    desk.show(desk.view);
    desk.key(Key::escape);
    EXPECT_FALSE(desk.has("divergence"));
    desk.view.divergence = blow_up(20);
    desk.show(desk.view);
    EXPECT_TRUE(desk.has("divergence"));
}

}  // namespace
}  // namespace steplab::ui
