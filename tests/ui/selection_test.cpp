#include "ui/selection.hpp"

#include "sim/catalogue.hpp"
#include "ui/recorder.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace steplab::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

/// What is asked for when this view comes.
std::vector<std::string> asked(Selection selection, const RunView& view) {
    Recorder recorder;
    selection.follow(view, true, recorder);
    return recorder.calls;
}

TEST(Selection, has_samples_tell_of_others_until_they_do) {
    const Simulation chain(describe("chain"));
    const Selection selection(ParticleList({7, 2, 5, 900}));
    EXPECT_THAT(asked(selection, view_of(chain, 5)), ElementsAre("also track 2 7")) << "those that there are";
    EXPECT_THAT(asked(selection, view_of(chain, TrackedParticles{5, 2})), ElementsAre("also track 2 7"));
    EXPECT_THAT(asked(selection, view_of(chain, TrackedParticles{5, 7, 2})), ElementsAre("also track 2 7"));
    EXPECT_THAT(asked(selection, view_of(chain, TrackedParticles{5, 2, 7})), IsEmpty());
    EXPECT_THAT(asked(Selection(), view_of(chain, TrackedParticles{5, 2, 7})), ElementsAre("also track"));
    EXPECT_THAT(asked(Selection(), view_of(chain, 5)), IsEmpty());
    EXPECT_THAT(asked(selection, view_of(chain)), IsEmpty()) << "nothing is tracked yet";
}

// A run that stands still sends no new view.
TEST(Selection, is_told_at_once_and_again_only_when_a_new_view_does_not_know_it) {
    const RunView view = view_of(Simulation(describe("chain")), 5);
    Recorder recorder;
    const auto told = [&](Selection& selection, bool is_new) {
        selection.follow(view, is_new, recorder);
        return std::exchange(recorder.calls, {});
    };
    Selection selection;
    EXPECT_THAT(told(selection, true), IsEmpty());
    selection.toggle(2, view, recorder);
    EXPECT_THAT(told(selection, false), ElementsAre("also track 2"));
    EXPECT_THAT(told(selection, false), IsEmpty()) << "it is on its way";
    EXPECT_THAT(told(selection, true), ElementsAre("also track 2"));
    selection.toggle(2, view, recorder);
    EXPECT_THAT(told(selection, false), IsEmpty()) << "the view has none";
    EXPECT_EQ(selection.count(view), 1u);
    EXPECT_EQ(Selection(ParticleList({5, 7, 900})).count(view), 2u);
}

TEST(Selection, of_many_particles_asks_for_as_many_as_samples_tell_of) {
    std::vector<std::size_t> all(10);
    std::iota(all.begin(), all.end(), 0);
    const Simulation chain(describe("chain"));
    EXPECT_THAT(asked(Selection{ParticleList(all)}, view_of(chain, 9)), ElementsAre("also track 0 1 2 3 4 5 6"));
    EXPECT_THAT(asked(Selection{ParticleList(all)}, view_of(chain, TrackedParticles{9, 0, 1, 2, 3, 4, 5, 6})),
                IsEmpty());
}

}  // namespace
}  // namespace steplab::ui
