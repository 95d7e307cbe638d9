#include "sim/run/opening.hpp"

#include "app/cli/scene_options.hpp"
#include "core/error.hpp"
#include "sim/catalogue.hpp"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab {
namespace {

RunDescription described(SceneOptions options, const std::string& arguments) {
    CLI::App app;
    options.declare(app);
    app.parse(arguments);
    return options.description();
}

RunDescription opened(const std::string& arguments) {
    return described(SceneOptions(SceneOptions::Defaults::recommended), arguments);
}

TEST(Opening, of_a_model_is_what_its_entry_recommends) {
    for (const Model& entry : models()) {
        const RunDescription run = opened("--model " + std::string(entry.info.id));
        EXPECT_EQ(run, opening(describe(entry.info.id))) << entry.info.id;
        EXPECT_EQ(run.method, entry.opening.method);
        EXPECT_EQ(run.dt, entry.opening.dt);
    }
}

TEST(Opening, takes_what_is_given) {
    const RunDescription run = opened("--model rope --method verlet --precision float");
    EXPECT_EQ(run.method, "verlet");
    EXPECT_EQ(run.precision, Precision::float_);
    EXPECT_EQ(run.dt, model("rope").opening.dt);
    EXPECT_EQ(opened("--model rope --dt 0.1").dt, 0.1);
    EXPECT_EQ(opened("--model rope --dt 0.1").method, model("rope").opening.method);
    EXPECT_EQ(opened("--model morse --method stoermer --set substeps=3 --set edge=2").method_parameters["substeps"], 3);
}

// A scene that is stiffer than the default one is opened with a dt that is shorter in proportion.
TEST(Opening, suits_the_parameters_of_the_scene) {
    EXPECT_EQ(opened("--model chain --set k=100").dt, 0.01);
    EXPECT_EQ(opened("--model morse --set k=50").dt, 0.001);
    EXPECT_EQ(opened("--model morse --set k=0.05").dt, model("morse").opening.dt);
    for (const char* scene :
         {"chain --set k=7000", "rope --set k=3e4", "mesh --set m=0.01", "oscillator --set k=1e4"}) {
        const RunDescription run = opened(std::string("--model ") + scene);
        const RunDescription usual = opening(describe(run.model));
        EXPECT_LE(run.dt * fastest_frequency(run), 1.000001 * usual.dt * fastest_frequency(usual)) << scene;
    }
}

TEST(Opening, is_the_windows_alone) {
    for (const Model& entry : models()) {
        const RunDescription run = described(SceneOptions(), "--model " + std::string(entry.info.id));
        EXPECT_EQ(run.method, "rk4") << entry.info.id;
        EXPECT_EQ(run.dt, 0.1) << entry.info.id;
        EXPECT_EQ(run.precision, Precision::double_) << entry.info.id;
    }
}

// "Copy command" gives the same run back whatever the defaults are.
TEST(Opening, is_named_by_its_command) {
    for (const Model& entry : models()) {
        const RunDescription run = opening(describe(entry.info.id));
        EXPECT_EQ(described(SceneOptions(), command_line(run)), run) << entry.info.id;
        EXPECT_EQ(opened(command_line(run)), run) << entry.info.id;
        EXPECT_THAT(command_line(run), testing::HasSubstr("--method " + run.method));
        EXPECT_THAT(command_line(run), testing::HasSubstr("--dt "));
    }
}

TEST(Opening, refuses_parameters_that_nobody_has) {
    EXPECT_THROW(opened("--model chain --set substeps=3"), UsageError);
    EXPECT_THROW(opened("--model chain --set n=1"), UsageError);
    EXPECT_THROW(opened("--model chain --dt 0"), UsageError);
}

}  // namespace
}  // namespace steplab
