#include "app/png.hpp"
#include "app/program.hpp"
#include "io/files.hpp"
#include "io/scene_file.hpp"
#include "io/shared_files.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

// What a scene's file says of how it is shown, and the pictures of scenes that come with the program.

namespace steplab {
namespace {

using testing::HasSubstr;

const std::string scene = R"(steplab = 1
[[particles]]
line = { count = 4, step = [1, 0, 0] }
[[fields]]
gravity = [0, -1, 0]
)";
const std::string view = "[view]\ncamera = \"30,20,8,0.7,0.9,0.7\"\ncolour = \"speed\"\nbackground = \"light\"\n";

/// The picture that `snapshot` draws of a scene file with these options.
class Drawn : public testing::Test {
protected:
    std::string picture(const std::string& text, std::vector<std::string> options) const {
        put_text(folder.file("a.toml"), text);
        std::vector<std::string> command{"snapshot", "--scene", folder.file("a.toml"), "--steps", "3", "--size",
                                         "200x150",  "--out",   folder.file("a.png")};
        command.insert(command.end(), options.begin(), options.end());
        const Outcome outcome = run_program(command);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return text_of(folder.file("a.png"));
    }
    TemporaryFolder folder;
};

TEST_F(Drawn, view_of_the_file_is_that_of_the_same_options) {
    const std::string drawn = picture(scene + view, {});
    EXPECT_TRUE(drawn ==
                picture(scene, {"--view", "30,20,8,0.7,0.9,0.7", "--colour", "speed", "--background", "light"}));
    EXPECT_FALSE(drawn == picture(scene, {}));
}

TEST_F(Drawn, options_go_before_the_file) {
    EXPECT_TRUE(picture(scene + view, {"--view", "default", "--colour", "role", "--background", "dark"}) ==
                picture(scene, {}));
}

TEST_F(Drawn, wrong_view_is_an_error_of_the_file) {
    put_text(folder.file("a.toml"), scene + "[view]\ncamera = \"here\"\n");
    for (const char* command : {"run", "snapshot"}) {
        const Outcome outcome = run_program({command, "--scene", folder.file("a.toml"), "--out", folder.file("b.png")});
        EXPECT_EQ(outcome.code, 3) << command;
        EXPECT_THAT(outcome.err, HasSubstr("a.toml:7:10: camera must be default, front, side, top or")) << command;
    }
}

// All pictures of the page of scenes have one size, twice that of a tile.
TEST(Pictures, of_every_model_and_every_shipped_scene_are_there) {
    std::vector<std::string> ids = shipped_scenes();
    for (const Model& model : models()) {
        EXPECT_FALSE(model.topic.empty()) << model.info.id << " needs a topic";
        ids.emplace_back(model.info.id);
    }
    for (const std::string& id : ids) {
        const auto file = shared_file("pictures", id + ".png");
        ASSERT_FALSE(file.empty()) << "scripts/renew.sh scenes draws the picture of " << id;
        const ReadPicture picture = read_png(file);
        EXPECT_EQ(picture.width, 352) << id;
        EXPECT_EQ(picture.height, 220) << id;
        EXPECT_EQ(picture.rgba.size(), std::size_t{4} * 352 * 220) << id;
        const auto differs = [&](std::uint8_t byte) { return byte != picture.rgba[0]; };
        EXPECT_TRUE(std::any_of(picture.rgba.begin(), picture.rgba.end(), differs)) << id << " is empty";
    }
}

TEST(Pictures, shipped_scenes_have_a_topic) {
    for (const std::string& name : shipped_scenes())
        EXPECT_FALSE(find_scene(name)->model->topic.empty()) << name << " needs a topic";
}

}  // namespace
}  // namespace steplab
