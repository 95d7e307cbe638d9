#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"
#include "sim/run/simulation.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

// What a scene file says of how its scene opens, read and written.

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string two = R"(steplab = 1
title = "Two"

[parameters]
k = { value = 4, range = [1, 9], what = "stiffness" }

[[particles]]
group = "pair"
line = { count = 2, step = [1, 0, 0] }

[[springs]]
between = "pair"
k = "k"
)";

TEST(SceneAppearance, a_view_is_kept_as_it_is_written) {
    const SceneOrigin scene = read_scene(two + R"([view]
camera = "30,20,8,0.7,0.9,0.7"
colour = "kinetic-energy"
background = "light"
)");
    EXPECT_EQ(scene->defaults.camera, "30,20,8,0.7,0.9,0.7");
    EXPECT_EQ(scene->defaults.colour, "kinetic-energy");
    EXPECT_EQ(scene->defaults.background, "light");
}

TEST(SceneAppearance, a_wrong_view_is_an_error_at_its_place) {
    EXPECT_THAT(refusal_of_scene(two + "[view]\ncamera = \"up\"\n"),
                StartsWith("a.toml:15:10: camera must be default, front"));
    EXPECT_THAT(refusal_of_scene(two + "[view]\ncamera = \"1,2,0,4,5,6\"\n"),
                StartsWith("a.toml:15:10: camera must be"));
    EXPECT_THAT(refusal_of_scene(two + "[view]\n\ncolour = \"sped\"\n"),
                StartsWith("a.toml:16:10: unknown colouring 'sped' (did you mean 'speed'?)"));
    EXPECT_THAT(refusal_of_scene(two + "[view]\nbackground = \"grey\"\n"),
                StartsWith("a.toml:15:14: unknown background"));
    EXPECT_THAT(refusal_of_scene(two + "[view]\ncolour = 1\n"), StartsWith("a.toml:15:10: must be a text"));
    EXPECT_THAT(refusal_of_scene(two + "[view]\ncolor = \"speed\"\n"), StartsWith("a.toml:15:1: unknown key 'color'"));
}

TEST(SceneAppearance, a_topic_is_one_of_five) {
    EXPECT_EQ(read_scene("topic = \"hard cases\"\n" + two)->model->topic, "hard cases");
    EXPECT_EQ(read_scene(two)->model->topic, "");
    EXPECT_THAT(refusal_of_scene("topic = \"plants\"\n" + two),
                StartsWith("a.toml:1:9: unknown topic 'plants' (did you mean 'planets'?)"));
}

TEST(SceneAppearance, parameters_of_the_method_are_its_own) {
    const std::string run = "[run]\nparameters = { tolerance = 1e-9 }\nmethod = \"dopri5\"\n";
    EXPECT_EQ(describe(read_scene(two + run)).method_parameters["tolerance"], 1e-9);
    EXPECT_THAT(refusal_of_scene(two + "[run]\nmethod = \"rk4\"\nparameters = { tolerance = 1e-9 }\n"),
                StartsWith("a.toml:16:16: unknown key 'tolerance' of the parameters of rk4"));
    EXPECT_THAT(refusal_of_scene(two + "[run]\nmethod = \"dopri5\"\nparameters = { tolerance = -1 }\n"),
                StartsWith("a.toml:16:28: tolerance must be"));
    EXPECT_THAT(refusal_of_scene(two + "[run]\nmethod = \"dopri5\"\nparameters = 3\n"), StartsWith("a.toml:16:14: "));
}

// A scene that was saved opens as it was: the same run with the same view.
TEST(SceneAppearance, what_is_written_opens_as_it_was) {
    RunDescription run =
        with_method(describe(read_scene(two + "[run]\nuntil = 7\ncompare = [\"dt=0.1\"]\n")), "dopri5");
    run.method_parameters.set("tolerance", 1e-7);
    run.scene.set("k", 5);
    run.dt = 0.03;
    run.precision = Precision::float_;
    const SceneView view{.camera = "30,20,8,0.7,0.9,0.7", .colour = "speed", .background = "light"};
    const RunDescription again = describe(read_scene(scene_file_text(run, view)));
    EXPECT_EQ(again.method, run.method);
    EXPECT_EQ(again.method_parameters, run.method_parameters);
    EXPECT_EQ(again.scene["k"], 5);
    EXPECT_EQ(again.dt, run.dt);
    EXPECT_EQ(again.precision, run.precision);
    const SceneDefaults& defaults = again.origin->defaults;
    EXPECT_EQ(defaults.camera, view.camera);
    EXPECT_EQ(defaults.colour, view.colour);
    EXPECT_EQ(defaults.background, view.background);
    EXPECT_EQ(defaults.until, 7);
    EXPECT_EQ(defaults.compare, run.origin->defaults.compare);
}

TEST(SceneAppearance, exporting_keeps_view_and_topic) {
    const std::string text =
        scene_file_text(describe(read_scene("topic = \"planets\"\n" + two + "[view]\ncolour = \"speed\"\n")));
    EXPECT_THAT(text, HasSubstr("topic = \"planets\""));
    EXPECT_THAT(text, HasSubstr("[view]\ncolour = \"speed\"\n"));
    for (const Model& model : models())
        EXPECT_EQ(read_scene(scene_file_text(describe(model.info.id)))->model->topic, model.topic) << model.info.id;
}

TEST(SceneAppearance, a_file_read_again_keeps_what_the_window_changed) {
    RunDescription now = describe(read_scene(two + "[run]\nmethod = \"velocity-verlet\"\ndt = 0.01\n"));
    const RunDescription fresh =
        describe(read_scene(two + "[fields]\ndrag = 0.1\n[run]\nmethod = \"rk4\"\ndt = 0.02\nprecision = \"float\"\n"));
    EXPECT_EQ(reloaded(now, fresh), fresh);
    now.dt = 0.005;
    now.scene.set("k", 7);
    const RunDescription then = reloaded(now, fresh);
    EXPECT_EQ(then.origin, fresh.origin);
    EXPECT_EQ(then.dt, 0.005);
    EXPECT_EQ(then.scene["k"], 7);
    EXPECT_EQ(then.method, "rk4");
    EXPECT_EQ(then.precision, Precision::float_);
    now = with_method(now, "euler");
    EXPECT_EQ(reloaded(now, fresh).method, "euler");
}

}  // namespace
}  // namespace steplab::test
