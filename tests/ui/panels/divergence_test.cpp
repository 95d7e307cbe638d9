#include "lab/limits/blow_up.hpp"
#include "render/framing.hpp"
#include "sim/catalogue.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace steplab::ui {
namespace {

using testing::ElementsAre;

/// A run that went to its end in a real divergence.
RunView diverged(const std::string& method, double dt) {
    RunDescription description = describe("chain", method);
    description.dt = dt;
    Simulation simulation(description);
    simulation.advance(100000);
    return view_of(simulation);
}

class Diverged : public testing::Test {
protected:
    explicit Diverged(const Display& display = {1280, 1200, 1}) : desk(chain(), display) {
        desk.view = diverged("euler", 2.5);
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        explain();
        desk.calls();
    }

    void explain() {
        BlowUpStudy study(std::vector<SegmentBegin>{{0, desk.view.description}}, *desk.view.divergence);
        while (study.next()) {
        }
        desk.session.blow_up = std::make_shared<const BlowUp>(study.found());
        desk.frame();
        desk.frame();
    }
    /// The remedy of the card that keeps the method, or the other.
    const TriedRemedy& remedy(bool keeps_method) const {
        const auto& tried = desk.session.blow_up->tried;
        return *std::find_if(tried.begin(), tried.end(), [&](const TriedRemedy& it) {
            return it.works && (it.run.method == desk.view.description.method) == keeps_method;
        });
    }
    static RunDescription chain() {
        RunDescription description = describe("chain", "euler");
        description.dt = 2.5;
        return description;
    }
    Desk desk;
};

/// The same in a window of this size.
struct DivergedIn : Diverged {
    explicit DivergedIn(const Display& display) : Diverged(display) {}
    using Diverged::desk;
    void TestBody() override {}
};

// Its title stood above the edge of a small window, and a button out of its own.
TEST(Divergence, card_is_whole_in_small_windows_with_all_its_buttons) {
    for (const Display display :
         {Display{640, 480, 1}, {400, 300, 1}, {800, 600, 1.5f}, {1280, 800, 2}, {500, 900, 1}}) {
        DivergedIn diverged(display);
        Desk& desk = diverged.desk;
        for (int i = 0; i < 3; ++i) desk.frame();
        const WidgetRect card = desk.widget("divergence");
        EXPECT_GE(card.left, 0);
        EXPECT_GE(card.top, 0);
        EXPECT_LE(card.right, static_cast<float>(display.width));
        EXPECT_LE(card.bottom, static_cast<float>(display.height));
        for (const char* const button : {"divergence.beginning", "remedy.restart", "divergence.page"}) {
            const WidgetRect place = desk.widget(button);
            EXPECT_GT(place.left, card.left) << button << " at " << display.width;
            EXPECT_LT(place.right, card.right) << button << " at " << display.width;
        }
        EXPECT_LT(desk.widget("divergence.close").right, card.right);
    }
}

bool overlap(const WidgetRect& card, const WidgetRect& place) {
    return card.left < place.right && card.right > place.left && card.top < place.bottom && card.bottom > place.top;
}

// It stood over the right half of a chain.
TEST(Divergence, card_shows_the_particles_that_it_speaks_of) {
    for (const Display display : {Display{1280, 800, 1}, {1280, 1200, 1}, {1000, 900, 1}}) {
        DivergedIn diverged(display);
        Desk& desk = diverged.desk;
        desk.view.frame.oscillation = desk.session.blow_up->limit.oscillation.shape;
        desk.camera = render::camera_of("default", view_of(Simulation(describe("chain"))).frame,
                                        {desk.interface.scene().width, desk.interface.scene().height});
        desk.view.frame.positions = desk.view.frame.shape->rest;  // those that blew up are far out of the picture
        const render::Camera usual = desk.camera;
        for (const double to_the_right : {-0.4, 0.0, 0.4}) {
            for (const double up : {-0.25, 0.0, 0.25}) {
                const PixelRect scene = desk.interface.scene();
                const render::Projection projection(usual, {scene.width, scene.height});
                desk.camera = render::panned(projection, to_the_right * scene.width, -up * scene.height);
                for (int i = 0; i < 3; ++i) desk.frame();
                double hidden = 0, all = 0;
                for (std::size_t i = 0; i < desk.view.frame.positions.size(); ++i) {
                    const Vec3 swing = desk.view.frame.oscillation[i];
                    const auto pixel =
                        render::Projection(desk.camera, {scene.width, scene.height}).pixel(desk.view.frame.seen(i));
                    const auto x = static_cast<float>(scene.x + pixel->x), y = static_cast<float>(scene.y + pixel->y);
                    all += dot(swing, swing);
                    if (overlap(desk.widget("divergence"), {x, y, x, y})) hidden += dot(swing, swing);
                }
                EXPECT_LE(hidden, 0.02 * all)
                    << display.width << " x " << display.height << ", moved by " << to_the_right << ", " << up;
            }
        }
    }
}

TEST_F(Diverged, card_stays_under_the_pointer) {
    desk.view.frame.oscillation = desk.session.blow_up->limit.oscillation.shape;
    desk.point_at("divergence");
    const WidgetRect before = desk.widget("divergence");
    desk.camera.focus.y += 0.4 * desk.camera.distance;
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_EQ(desk.widget("divergence"), before);
}

TEST_F(Diverged, limits_on_the_card_are_explained) {
    for (const char* const paragraph : {"divergence.message", "divergence.why", "remedy.dt.trial"}) {
        desk.point_at(paragraph);
        desk.frame();
        EXPECT_TRUE(desk.has("tooltip")) << paragraph;
    }
    desk.point_at("divergence.beginning");
    desk.session.blow_up = nullptr;
    desk.view.divergence->limit.reset();
    for (int i = 0; i < 3; ++i) desk.frame();
    desk.point_at("divergence.message");
    desk.frame();
    EXPECT_FALSE(desk.has("tooltip")) << "no limit is named";
}

TEST_F(Diverged, card_appears_with_its_remedies) {
    ASSERT_TRUE(desk.view.divergence);
    EXPECT_FALSE(desk.view.divergence->message.empty());
    EXPECT_TRUE(desk.has("divergence"));
    EXPECT_TRUE(desk.has("remedy.dt"));
    EXPECT_TRUE(desk.has("remedy.method"));
}

TEST_F(Diverged, card_offers_nothing_that_was_not_tried) {
    BlowUp untried = *desk.session.blow_up;
    for (TriedRemedy& tried : untried.tried) tried.works = false;
    desk.session.blow_up = std::make_shared<const BlowUp>(untried);
    desk.frame();
    EXPECT_FALSE(desk.has("remedy.dt"));
    EXPECT_FALSE(desk.has("remedy.method"));
    desk.session.blow_up.reset();
    desk.frame();
    EXPECT_FALSE(desk.has("remedy.dt"));
    EXPECT_TRUE(desk.has("remedy.restart"));
}

TEST_F(Diverged, beginning_is_shown_with_the_oscillation_that_grew) {
    EXPECT_TRUE(desk.style.oscillation) << "while the card stands";
    desk.click("divergence.beginning");
    EXPECT_THAT(desk.calls(), ElementsAre("pause", "seek"));
    desk.view.divergence.reset();
    desk.session.blow_up.reset();
    desk.frame();
    EXPECT_TRUE(desk.style.oscillation) << "there, too";
    desk.click("oscillation");
    desk.frame();
    EXPECT_FALSE(desk.style.oscillation);
}

TEST_F(Diverged, arrows_of_its_card_end_with_the_run) {
    desk.click("divergence.beginning");
    RunView next = view_of(Simulation(describe("mesh")));
    next.run = desk.view.run + 1;
    desk.session.blow_up.reset();
    desk.show(next);
    EXPECT_FALSE(desk.style.oscillation);
    desk.click("oscillation");
    next.run += 1;
    desk.show(next);
    EXPECT_TRUE(desk.style.oscillation) << "a choice stays";
}

TEST_F(Diverged, card_offers_a_run_beside_that_goes_on) {
    EXPECT_FALSE(desk.has("divergence.lead")) << "there is none";
    desk.session.followers = {desk.view, view_of(Simulation(describe("chain", "rk4")))};
    desk.frame();
    desk.frame();
    desk.click("divergence.lead");
    ASSERT_TRUE(std::holds_alternative<event::Lead>(desk.recorder.events.back()));
    EXPECT_EQ(std::get<event::Lead>(desk.recorder.events.back()).run, 2u) << "the first of them diverged, too";
}

TEST_F(Diverged, card_leads_to_its_page) {
    desk.click("divergence.page");
    const std::vector<Request> requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests.front().kind, Request::Kind::open_page);
    EXPECT_EQ(requests.front().text, "divergence.md");
}

// ImGui knows the size of a new card one frame later: it must be drawn without any input.
TEST(Divergence, card_asks_for_frames_until_it_stands) {
    Desk desk(describe("chain", "euler"));
    for (int i = 0; i < 5; ++i) desk.frame();
    desk.view = diverged("euler", 2.5);
    desk.interface.record(desk.view);
    desk.frame();
    int frames = 1;
    for (; desk.interface.seconds_until_change() <= 0 && frames < 100; ++frames) desk.frame();
    EXPECT_LT(frames, 10);
    const WidgetRect stands = desk.widget("remedy.restart");
    for (int i = 0; i < 5; ++i) desk.frame();
    EXPECT_EQ(desk.widget("remedy.restart"), stands);
}

TEST_F(Diverged, smaller_dt_restarts_and_plays) {
    desk.click("remedy.dt");
    EXPECT_THAT(desk.calls(), ElementsAre("change", "restart", "play"));
    EXPECT_EQ(desk.wanted(), remedy(true).run);
    EXPECT_LT(desk.wanted().dt, 2 / 1.97272261) << "below Euler's limit of 2 / omega_max of ten points";
}

TEST_F(Diverged, other_method_keeps_dt_and_is_stable_there) {
    desk.click("remedy.method");
    EXPECT_THAT(desk.calls(), ElementsAre("change", "restart", "play"));
    EXPECT_EQ(desk.wanted().dt, 2.5);
    EXPECT_EQ(desk.wanted().method, "stoermer") << "ten substeps are the only ones stable at 2.5 times 1.97";
}

TEST_F(Diverged, remedies_cure_the_real_run) {
    for (const std::string_view widget : {"remedy.dt", "remedy.method"}) {
        desk.click(widget);
        Simulation simulation(desk.wanted());
        simulation.advance(5000);
        EXPECT_FALSE(simulation.divergence()) << widget;
    }
}

TEST_F(Diverged, card_can_be_closed_and_comes_back_with_the_next_divergence) {
    desk.click("divergence.close");
    EXPECT_FALSE(desk.has("divergence"));
    desk.view.divergence->step += 1;
    desk.frame();
    desk.frame();
    EXPECT_TRUE(desk.has("divergence"));
}

TEST_F(Diverged, run_cannot_be_played_but_restarted) {
    desk.click("divergence.close");
    desk.click("play");
    desk.click("step");
    EXPECT_TRUE(desk.calls().empty());
    desk.click("restart");
    EXPECT_THAT(desk.calls(), ElementsAre("restart"));
}

TEST(divergence, a_good_run_has_no_card) {
    Desk desk;
    EXPECT_FALSE(desk.has("divergence"));
}

}  // namespace
}  // namespace steplab::ui
