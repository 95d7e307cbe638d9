#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(panel, model_is_chosen_from_its_menu) {
    for (const Model& model : models()) {
        Desk desk(describe(model.info.id == "mesh" ? "chain" : "mesh"));
        desk.click("model");
        desk.click("model/" + std::string(model.info.id));
        ASSERT_EQ(desk.recorder.changes.size(), 1u) << model.info.id;
        EXPECT_EQ(desk.wanted(), opening(with_model(desk.view.description, model.info.id)));
    }
}

TEST(panel, choosing_the_model_that_runs_changes_nothing) {
    Desk desk(describe("mesh"));
    desk.click("model");
    desk.click("model/mesh");
    EXPECT_THAT(desk.recorder.changes, IsEmpty());
}

TEST(panel, method_is_chosen_from_its_menu) {
    for (const Method& method : methods()) {
        Desk desk(describe("chain", method.info.id == "rk4" ? "euler" : "rk4"));
        desk.click("method");
        desk.click("method/" + std::string(method.info.id));
        ASSERT_EQ(desk.recorder.changes.size(), 1u) << method.info.id;
        EXPECT_EQ(desk.wanted(), with_method(desk.view.description, method.info.id));
    }
}

TEST(panel, methods_are_grouped_by_what_their_entries_say) {
    Desk desk(describe("chain"), {1280, 1400, 1});
    desk.click("method");
    const auto height = [&](const std::string& name) { return desk.widget("method/" + name).top; };
    const std::string groups[] = {"[explicit, fixed step]", "[symplectic, explicit]", "[adaptive step size]",
                                  "[implicit]", "[as printed in 2008]"};
    for (std::size_t i = 1; i < std::size(groups); ++i) EXPECT_LT(height(groups[i - 1]), height(groups[i]));
    for (const Method& method : methods()) {
        const MethodInfo& info = method.info;
        const std::size_t group = info.curiosity ? 4 : info.implicit ? 3 : info.adaptive ? 2 : info.symplectic ? 1 : 0;
        const float place = height(std::string(info.id));
        EXPECT_GT(place, height(groups[group])) << info.id;
        EXPECT_TRUE(group + 1 == std::size(groups) || place < height(groups[group + 1])) << info.id;
    }
}

TEST(panel, precision_is_switched) {
    Desk desk;
    desk.click("precision/float");
    EXPECT_EQ(desk.wanted().precision, Precision::float_);
    desk.click("precision/double");
    EXPECT_EQ(desk.wanted().precision, Precision::double_);
}

TEST(panel, the_precision_that_runs_is_not_asked_for_again) {
    Desk desk;
    desk.click("precision/double");
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(panel, transport_buttons_send_their_commands) {
    Desk desk;
    desk.view.can_step_back = true;
    desk.click("play");
    EXPECT_THAT(desk.calls(), ElementsAre("play"));
    desk.view.playing = true;
    desk.frame();
    desk.click("play");
    EXPECT_THAT(desk.calls(), ElementsAre("pause"));
    desk.click("step");
    EXPECT_THAT(desk.calls(), ElementsAre("step forward"));
    desk.click("step back");
    EXPECT_THAT(desk.calls(), ElementsAre("step back"));
    desk.click("restart");
    EXPECT_THAT(desk.calls(), ElementsAre("restart"));
}

TEST(panel, step_back_does_nothing_at_the_start) {
    Desk desk;
    ASSERT_FALSE(desk.view.can_step_back);
    desk.click("step back");
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(panel, play_button_answers_before_the_run_does) {
    Desk desk;
    desk.click("play");
    desk.click("play");
    EXPECT_THAT(desk.calls(), ElementsAre("play", "pause"));
}

TEST(panel, a_run_that_does_not_start_to_play_is_shown_as_it_is) {
    Desk desk;
    desk.click("play");
    for (int i = 0; i < 10; ++i) {
        desk.interface.record(desk.view);
        desk.frame();
    }
    desk.click("play");
    EXPECT_THAT(desk.calls(), ElementsAre("play", "play"));
}

// The run stands still: no view would come to say that it does not play.
TEST(panel, a_run_that_is_over_is_not_shown_as_if_it_played) {
    Desk desk;
    desk.view.divergence.emplace();
    desk.show(desk.view);
    desk.key(Key::space);
    desk.view.divergence.reset();  // another run leads
    desk.interface.record(desk.view);
    desk.frame();
    desk.key(Key::space);
    EXPECT_THAT(desk.calls(), ElementsAre("play", "play")) << "no press is lost";
}

TEST(panel, what_stands_at_its_start_is_not_shown_as_if_it_played_backwards) {
    Desk desk;
    ASSERT_EQ(desk.view.frame.step, 0u);
    desk.key(Key::j);
    desk.key(Key::space);
    EXPECT_THAT(desk.calls(), ElementsAre("play", "play"));
}

// It diverges before a view shows that it plays: from then on it stands, and Play is to play.
TEST(panel, a_run_that_diverges_at_once_is_shown_as_it_stands) {
    for (const bool diverges : {true, false}) {
        Desk desk;
        desk.click("play");
        EXPECT_THAT(desk.calls(), ElementsAre("play"));
        if (diverges) desk.view.divergence.emplace();
        desk.show(desk.view);
        desk.view.divergence.reset();  // back before it
        desk.show(desk.view);
        desk.click("play");
        EXPECT_THAT(desk.calls(), ElementsAre(diverges ? "play" : "pause"));
    }
}

TEST(panel, dt_is_dragged_logarithmically) {
    Desk desk;
    desk.drag("dt", 0.5f, 0.75f);
    ASSERT_FALSE(desk.recorder.changes.empty());
    // Three quarters of 1e-4 .. 10 is 10^-0.25. The knob keeps its radius, 6 % of the slider, from both ends, which
    // moves its middle by 3 % of five decades there.
    EXPECT_NEAR(std::log10(desk.wanted().dt), -0.25, 0.2);
    for (const RunDescription& change : desk.recorder.changes) {
        EXPECT_EQ(with_method(change, "rk4").model, desk.view.description.model);
    }
}

TEST(panel, every_change_of_a_dragged_slider_differs_from_the_one_before) {
    Desk desk;
    desk.drag("dt", 0.2f, 0.8f);
    for (std::size_t i = 1; i < desk.recorder.changes.size(); ++i) {
        EXPECT_NE(desk.recorder.changes[i - 1], desk.recorder.changes[i]);
    }
    const std::size_t sent = desk.recorder.changes.size();
    for (int i = 0; i < 20; ++i) desk.frame();
    EXPECT_EQ(desk.recorder.changes.size(), sent);
}

TEST(panel, changes_build_on_those_the_run_has_not_made_yet) {
    Desk desk;
    desk.click("precision/float");
    desk.drag("dt", 0.5f, 0.3f);
    EXPECT_EQ(desk.wanted().precision, Precision::float_);
    EXPECT_LT(desk.wanted().dt, 0.1);
}

TEST(panel, dt_is_typed_exactly) {
    for (const bool on_value : {true, false}) {
        Desk desk;
        on_value ? desk.click("dt.value") : desk.click_with_control("dt");
        ASSERT_TRUE(desk.has("dt.entry"));
        desk.type("0.0123456789");
        desk.key(Key::enter);
        ASSERT_EQ(desk.recorder.changes.size(), 1u);
        EXPECT_EQ(desk.wanted().dt, 0.0123456789);
        EXPECT_FALSE(desk.has("dt.entry"));
    }
}

TEST(panel, typed_nonsense_is_refused_with_a_message) {
    Desk desk;
    for (const std::string_view text : {"-1", "0", "nan", "quick", "1e999"}) {
        desk.click("dt.value");
        desk.type(text);
        desk.key(Key::enter);
        desk.frame();
        EXPECT_TRUE(desk.has("refusal")) << text;
        desk.click("refusal.close");
        EXPECT_FALSE(desk.has("refusal")) << text;
    }
    EXPECT_THAT(desk.recorder.changes, IsEmpty());
}

TEST(panel, escape_leaves_an_entry_without_a_change) {
    Desk desk;
    desk.click("dt.value");
    desk.type("7");
    desk.key(Key::escape);
    desk.frame();
    EXPECT_FALSE(desk.has("dt.entry"));
    EXPECT_THAT(desk.recorder.changes, IsEmpty());
}

TEST(panel, double_click_sets_dt_to_what_the_model_recommends) {
    for (const Model& model : models()) {
        RunDescription description = describe(model.info.id);
        description.dt = 0.003;
        Desk desk(description);
        desk.double_click("dt");
        EXPECT_EQ(desk.wanted().dt, model.opening.dt) << model.info.id;
    }
}

TEST(panel, what_the_run_refused_is_shown_and_taken_back) {
    Desk desk;
    for (int attempt = 0; attempt < 2; ++attempt) {  // the second time with the same words
        desk.drag("dt", 0.5f, 0.6f);
        desk.view.error = "no memory for this";
        ++desk.view.failures;
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        EXPECT_TRUE(desk.has("refusal"));
        desk.click("precision/float");
        EXPECT_EQ(desk.wanted().dt, 0.1);
        desk.view.description.precision = Precision::float_;
        desk.click("precision/double");
        desk.view.description.precision = Precision::double_;
    }
}

// Views that come later carry the message on: it is of no request made since.
TEST(panel, a_refusal_does_not_take_back_what_is_asked_for_after_it) {
    Desk desk;
    desk.view.error = "no memory for this";
    ++desk.view.failures;
    desk.interface.record(desk.view);
    desk.frame();
    desk.click("refusal.close");
    desk.click("precision/float");
    desk.interface.record(desk.view);
    desk.frame();
    desk.drag("dt", 0.5f, 0.3f);
    EXPECT_EQ(desk.wanted().precision, Precision::float_);
}

// The only thread that makes scenes is that of the run: what needs one, it says.
TEST(panel, a_scene_is_not_made_to_refuse_it) {
    Desk desk(with_method(describe("morse"), "taylor"));
    desk.click("scene.edge.value");
    desk.type("9");
    desk.key(Key::enter);
    desk.view.description.scene.set("edge", 9);
    desk.calls();
    desk.click("scene.cutoff.value");  // taylor refuses more than 50 particles with a cut-off
    desk.type("2");
    desk.key(Key::enter);
    EXPECT_THAT(desk.calls(), Contains("change"));
    EXPECT_THROW(check(desk.wanted()), UsageError);
}

TEST(panel, speed_has_a_slider_and_a_button_for_unlimited) {
    Desk desk;
    desk.drag("speed", 0.5f, 0.9f);
    ASSERT_FALSE(desk.recorder.rates.empty());
    EXPECT_GT(desk.recorder.rates.back().seconds_per_second, 10);
    desk.click("fastest");
    EXPECT_TRUE(desk.recorder.rates.back().as_fast_as_possible);
}

TEST(panel, show_switches_change_the_style) {
    Desk desk;
    ASSERT_TRUE(desk.style.springs);
    desk.click("springs");
    EXPECT_FALSE(desk.style.springs);
    desk.click("grid");
    EXPECT_FALSE(desk.style.grid);
    desk.click("background/light");
    EXPECT_EQ(desk.style.background, render::Background::light);
    desk.click("colouring");
    desk.click("colouring/speed");
    EXPECT_EQ(desk.style.colouring, render::Colouring::speed);
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(panel, menu_copies_command_and_view) {
    Desk desk(describe("rope", "verlet"));
    desk.click("menu");
    desk.click("menu/copy command");
    auto requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::copy_text);
    EXPECT_THAT(requests[0].text, testing::StartsWith("steplab view " + command_line(desk.view.description)));
    desk.click("menu");
    desk.click("menu/copy view");
    requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].text.find("steplab"), std::string::npos);
}

TEST(panel, footer_has_room_for_all_rates_at_any_time) {
    for (const float scale : {1.0f, 1.5f}) {
        Desk desk(describe("chain"), {1280, 1200, scale});
        const auto height = [&](std::optional<double> steps, std::optional<double> frame) {
            desk.view.steps_per_second = desk.view.evaluations_per_second = steps;
            desk.interface.draw(desk.session, desk.recorder, {desk.camera, desk.style}, {.frame_seconds = frame});
            return desk.widget("footer").bottom - desk.widget("footer").top;
        };
        const float none = height({}, {});
        EXPECT_GT(none, 2 * 12.5f * scale) << "all of them take two lines";
        EXPECT_EQ(height(420, {}), none);
        EXPECT_EQ(height(1.9e6, 0.0041), none);
    }
}

TEST(panel, snapshot_button_requests_a_snapshot) {
    Desk desk;
    desk.click("snapshot");
    const auto requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::save_snapshot);
}

}  // namespace
}  // namespace steplab::ui
