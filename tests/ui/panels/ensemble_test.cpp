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

/// The panel of a run with an ensemble.
class EnsemblePanel : public testing::Test {
protected:
    void show(const LiveEnsembleOptions& ensemble) {
        desk.view.ensemble = ensemble;
        desk.view.frame.ensemble.clear();
        for (std::size_t i = 0; i < ensemble.runs; ++i)
            desk.view.frame.ensemble.insert(desk.view.frame.ensemble.end(), desk.view.frame.positions.begin(),
                                            desk.view.frame.positions.end());
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        desk.calls();
    }
    const LiveEnsembleOptions& asked() const { return desk.recorder.ensembles.back(); }

    Desk desk{describe("morse")};
};

TEST_F(EnsemblePanel, is_one_row_until_there_is_an_ensemble) {
    EXPECT_TRUE(desk.has("ensemble/off"));
    EXPECT_FALSE(desk.has("ensemble spread"));
    EXPECT_FALSE(desk.has("ensemble width"));
    desk.click("ensemble/off");
    EXPECT_THAT(desk.calls(), Not(Contains("ensemble")));
    show({.runs = 16});
    EXPECT_TRUE(desk.has("ensemble spread"));
    EXPECT_TRUE(desk.has("ensemble width"));
}

TEST_F(EnsemblePanel, switches_it_on_and_off) {
    desk.click("ensemble/64");
    EXPECT_THAT(desk.calls(), Contains("ensemble"));
    EXPECT_EQ(asked(), LiveEnsembleOptions{.runs = 64});
    EXPECT_TRUE(desk.has("ensemble spread")) << "it answers before the run does";
    show({.runs = 64});
    desk.click("ensemble/off");
    EXPECT_EQ(asked().runs, 0u);
}

TEST_F(EnsemblePanel, chooses_the_perturbed_parameter) {
    show({.runs = 16, .spread = "v0"});
    desk.click("ensemble spread");
    desk.click("ensemble spread/spacing");
    EXPECT_EQ(asked(), (LiveEnsembleOptions{.runs = 16, .spread = "spacing"}));
    EXPECT_FALSE(desk.has("ensemble spread/edge")) << "particles cannot come and go";
}

TEST_F(EnsemblePanel, takes_its_width_typed_and_dragged) {
    show({.runs = 16});
    desk.click("ensemble width.value");
    desk.type("0.0125");
    desk.key(Key::enter);
    EXPECT_EQ(asked().width, 0.0125);
    const std::size_t before = desk.recorder.ensembles.size();
    desk.click("ensemble width.value");
    desk.type("0.7");
    desk.key(Key::enter);
    EXPECT_EQ(desk.recorder.ensembles.size(), before) << "beyond half the value";
    desk.drag("ensemble width", 0.5f, 0.2f);
    EXPECT_GT(desk.recorder.ensembles.size(), before);
    EXPECT_LT(asked().width, 1e-9);
}

TEST_F(EnsemblePanel, shows_the_state_of_the_run_once_an_ensemble_is_refused) {
    for (int attempt = 0; attempt < 2; ++attempt) {
        desk.click("ensemble/64");
        desk.frame();
        EXPECT_TRUE(desk.has("ensemble spread")) << "it was asked for, no answer yet";
        // A paused run sends only one view, with the reason.
        desk.view.error = "an ensemble of 64 runs is too large";
        ++desk.view.failures;
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        EXPECT_FALSE(desk.has("ensemble spread")) << "the run continues without it";
    }
}

TEST_F(EnsemblePanel, does_not_offer_to_change_a_perturbation_set_elsewhere) {
    show({.runs = 16, .otherwise = true});
    EXPECT_TRUE(desk.has("ensemble/off"));
    EXPECT_FALSE(desk.has("ensemble spread"));
    EXPECT_FALSE(desk.has("ensemble width"));
}

TEST_F(EnsemblePanel, keeps_the_run_as_it_is) {
    show({.runs = 16});
    desk.drag("ensemble width", 0.5f, 0.2f);
    EXPECT_THAT(desk.recorder.changes, IsEmpty());
}

}  // namespace
}  // namespace steplab::ui
