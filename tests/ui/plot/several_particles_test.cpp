// Plots of the motion of several particles that are selected.
#include "core/number_text.hpp"
#include "ui/plot/recorded.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

RunDescription swinging_chain() {
    RunDescription description = describe("chain", "rk4");
    description.dt = 0.05;
    return description;
}

/// The header of the table of a plot.
std::string header_of(Desk& desk, const std::string& kind) {
    choose(desk, 1, kind);
    const std::string table = saved_csv(desk, kind);
    return table.substr(0, table.find('\n'));
}

TEST(plots_of_several_particles, have_a_curve_of_each_and_its_exact_one) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 30, {5, 2, 9});
    const RunView& view = recorded.desk.view;
    const auto value = [](const Vec3& vector) { return number_text(vector.x); };
    const auto row = [&](const auto& of) {
        std::string text = number_text(view.frame.time);
        for (std::size_t place = 0; place < 3; ++place) text += "," + value(of(place, false));
        for (std::size_t place = 0; place < 3; ++place) text += "," + value(of(place, true));
        return text + "\n";
    };
    const std::string names = ",particle 5,particle 2,particle 9,exact,\"exact, particle 2\",\"exact, particle 9\"\n";
    const auto tracked = [&](std::size_t place) { return place == 0 ? *view.tracked : view.also_tracked[place - 1]; };
    const auto sample = [&](std::size_t place) { return *view.series.samples.back().particle(place); };
    const auto rest = [&](std::size_t place) { return view.frame.shape->rest[tracked(place).particle]; };
    const auto displacement = [&](std::size_t place, bool exact) {
        return exact ? *tracked(place).exact_displacement : sample(place).displacement;
    };
    const auto position = [&](std::size_t place, bool exact) { return rest(place) + displacement(place, exact); };
    const auto velocity = [&](std::size_t place, bool exact) {
        return exact ? tracked(place).exact->velocity(view.frame.time) : sample(place).velocity;
    };
    const std::string displacements = saved_csv(recorded.desk, "displacement");
    EXPECT_THAT(displacements, StartsWith("time" + names));
    EXPECT_THAT(displacements, HasSubstr(row(displacement)));
    choose(recorded.desk, 1, "position");
    EXPECT_THAT(saved_csv(recorded.desk, "position"), HasSubstr(row(position)));
    choose(recorded.desk, 1, "velocity");
    EXPECT_THAT(saved_csv(recorded.desk, "velocity"), HasSubstr(row(velocity)));
}

TEST(plots_of_several_particles, name_them_and_draw_them_in_phase_portraits_and_spectra) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 200, {5, 2});
    choose(recorded.desk, 1, "phase portrait");
    const std::string portraits = saved_csv(recorded.desk, "phase portrait");
    for (const char* const name : {"\nparticle 5,", "\nparticle 2,", "\nexact,", "\n\"exact, particle 2\","})
        EXPECT_THAT(portraits, HasSubstr(name));
    EXPECT_EQ(header_of(recorded.desk, "spectrum"), "angular frequency,particle 5,particle 2");
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.svg");
    EXPECT_THAT(text_of_file("steplab-displacement-1.svg"), ContainsRegex("displacement . of particles 5, 2"));
}

TEST(plots_of_several_particles, beside_other_runs_have_a_curve_of_each_in_each_run) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 30, {5, 2});
    RunView other = recorded.desk.view;
    other.description = swinging_chain();
    other.description.method = "verlet";
    other.swatch = 1;
    recorded.desk.session.followers = {other};
    recorded.desk.frame();
    EXPECT_THAT(header_of(recorded.desk, "displacement"),
                ContainsRegex("rk4[^\"]*, particle 5.*rk4[^\"]*, particle 2"
                              ".*verlet[^\"]*, particle 5.*verlet[^\"]*, particle 2.*exact"));
}

/// Colour and line of each curve of the legend of a drawing.
std::set<std::string> looks_of(const std::string& svg) {
    std::set<std::string> looks;
    const std::regex curve(
        "<g class=\"curve\"[^>]*stroke=\"([^\"]*)\"[^>]*><title>particle [^<]*</title>"
        "<polyline[^>]*?(stroke-dasharray=\"[^\"]*\")?[^>]*>");
    for (std::sregex_iterator match(svg.begin(), svg.end(), curve); match != std::sregex_iterator(); ++match)
        looks.insert((*match)[1].str() + (match->str().find("dasharray") != std::string::npos ? " dashed" : " solid"));
    return looks;
}

TEST(plots_of_several_particles, tell_all_of_them_apart) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 3, {9, 1, 2, 3, 4, 5, 6, 7});
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.svg");
    EXPECT_EQ(looks_of(text_of_file("steplab-displacement-1.svg")).size(), Sample::most_particles);
}

TEST(plots_of_several_particles, are_along_the_axis_in_which_one_of_them_moves) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 20, {0, 9});  // the first one is fixed
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.svg");
    EXPECT_THAT(text_of_file("steplab-displacement-1.svg"), HasSubstr("displacement x of particles 0, 9"));
}

TEST(plots_of_several_particles, say_how_many_of_those_selected_they_show) {
    const OwnFolder folder;
    Recorded recorded(swinging_chain(), 10, {0, 1, 2, 3, 4, 5, 6, 7});
    recorded.desk.interface.select_too(ParticleList({1, 2, 3, 4, 5, 6, 7, 8, 9}));
    recorded.desk.frame();
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.svg");
    EXPECT_THAT(text_of_file("steplab-displacement-1.svg"), ContainsRegex("displacement . of 8 of 10 particles"));
}

}  // namespace
}  // namespace steplab::ui
