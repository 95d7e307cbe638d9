// What a window remembers: read tolerantly, written whole, and only what has changed.
#include "app/cli/view_choices_file.hpp"

#include "io/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace steplab {
namespace {

using ui::PlotKind;
using ui::ViewChoices;

class ViewChoicesFile : public testing::Test {
protected:
    ReadViewChoices read_text(const std::string& text) {
        std::ofstream(path) << text;
        return read_view_choices(path);
    }
    std::string text() const {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    TemporaryFolder folder;
    std::string path = folder.file("steplab/view.toml");
};

ViewChoices other_choices() {
    return {.scale = 1.25,
            .background = Background::light,
            .colouring = Colouring::speed,
            .springs = false,
            .grid = false,
            .trail = true,
            .velocities = true,
            .forces = true,
            .panel = false,
            .sizes = {.panel_width = 321.5, .plots_height = 222},
            .plots = {{PlotKind::phase, plot::Scale::symmetric_logarithmic},
                      {PlotKind::costs},
                      {PlotKind::error, plot::Scale::linear, plot::Scale::logarithmic}},
            .width = 901,
            .height = 703,
            .picture = {.scene_alone = true, .caption = true, .film = ".webm"}};
}

TEST_F(ViewChoicesFile, what_is_written_is_read_again) {
    remember_view_choices(path, {}, other_choices());
    const ReadViewChoices read = read_view_choices(path);
    EXPECT_FALSE(read.problem) << *read.problem;
    const ViewChoices expected = other_choices();
    EXPECT_EQ(read.choices.scale, expected.scale);
    EXPECT_EQ(read.choices.background, expected.background);
    EXPECT_EQ(read.choices.colouring, expected.colouring);
    EXPECT_FALSE(read.choices.springs || read.choices.grid);
    EXPECT_TRUE(read.choices.trail && read.choices.velocities && read.choices.forces);
    EXPECT_EQ(read.choices.panel, expected.panel);
    EXPECT_EQ(read.choices.sizes, expected.sizes);
    EXPECT_TRUE(read.choices.plots == expected.plots);
    EXPECT_EQ(read.choices.width, expected.width);
    EXPECT_EQ(read.choices.height, expected.height);
    EXPECT_EQ(read.choices.picture, expected.picture);
}

TEST_F(ViewChoicesFile, numbers_are_the_shortest_that_read_back) {
    for (const double scale : ui::interface_scales) {
        ViewChoices choices;
        choices.scale = scale;
        choices.sizes = {.panel_width = 321.1, .plots_height = 222.7};
        remember_view_choices(path, {}, choices);
        for (const char* const number : {"panel_width = 321.1\n", "plots_height = 222.7\n", "width = 1280\n"})
            EXPECT_NE(text().find(number), std::string::npos) << number << " in " << text();
        EXPECT_EQ(read_view_choices(path).choices.scale, scale) << "also where the file has a whole number";
        EXPECT_TRUE(scale != 1.1 || text().find("\nscale = 1.1\n") != std::string::npos) << text();
        std::filesystem::remove(path);
    }
}

TEST_F(ViewChoicesFile, without_a_change_nothing_is_written) {
    remember_view_choices(path, other_choices(), other_choices());
    EXPECT_FALSE(std::filesystem::exists(path));
    remember_view_choices("", {}, other_choices());
    EXPECT_TRUE(folder.empty());
}

TEST_F(ViewChoicesFile, what_another_window_changed_meanwhile_stays) {
    ViewChoices one, other;
    one.scale = 1.5;
    other.background = Background::light;
    remember_view_choices(path, {}, one);
    remember_view_choices(path, {}, other);
    EXPECT_EQ(read_view_choices(path).choices.scale, 1.5);
    EXPECT_EQ(read_view_choices(path).choices.background, Background::light);
}

TEST_F(ViewChoicesFile, an_axis_across_of_which_nothing_is_said_is_as_the_plot_opens) {
    std::filesystem::create_directory(folder.file("steplab"));
    const ReadViewChoices read = read_text(
        "plots = [{kind = \"speed against error\", scale = \"logarithmic\"}, "
        "{kind = \"energies\", scale = \"linear\"}]\n");
    EXPECT_FALSE(read.problem);
    ASSERT_EQ(read.choices.plots.size(), 2u);
    EXPECT_EQ(read.choices.plots[0].across_scale, plot::Scale::logarithmic);
    EXPECT_EQ(read.choices.plots[1].across_scale, plot::Scale::linear);
}

TEST_F(ViewChoicesFile, values_that_cannot_be_used_are_named_and_the_others_hold) {
    std::filesystem::create_directory(folder.file("steplab"));
    for (const char* line :
         {"scale = 9", "scale = nan", "scale = \"large\"", "theme = \"pink\"", "grid = 1", "width = 100.5",
          "film = \".avi\"", "plots = []", "plots = [{kind = \"weather\"}]",
          "plots = [{kind = \"speeds\", scale = \"linear\", across = \"round\"}]",
          "plots = [{kind = \"speeds\", scale = \"linear\"}, {kind = \"speeds\", scale = \"linear\"}]"}) {
        const ReadViewChoices read = read_text(std::string(line) + "\nsprings = false\nunheard_of = 3\n");
        ASSERT_TRUE(read.problem) << line;
        const std::string key(line, std::string_view(line).find(' '));
        EXPECT_NE(read.problem->find(key + " (line 1)"), std::string::npos) << *read.problem;
        EXPECT_EQ(read.problem->find("unheard_of"), std::string::npos) << "of a version that knows more";
        EXPECT_FALSE(read.choices.springs) << line;
        EXPECT_EQ(read.choices.scale, 1);
    }
}

TEST_F(ViewChoicesFile, a_broken_file_gives_the_usual_choices_and_stays_beside_the_new_one) {
    std::filesystem::create_directory(folder.file("steplab"));
    const ReadViewChoices read = read_text("scale = 1.5\ngrid = = \n");
    ASSERT_TRUE(read.problem);
    EXPECT_NE(read.problem->find("line 2"), std::string::npos) << *read.problem;
    EXPECT_EQ(read.choices.scale, 1);
    remember_view_choices(path, {}, {});
    EXPECT_FALSE(std::filesystem::exists(path + ".unreadable")) << "nothing was chosen";
    const std::string broken = text();
    remember_view_choices(path, {}, other_choices());
    EXPECT_FALSE(read_view_choices(path).problem);
    std::filesystem::rename(path + ".unreadable", path);
    EXPECT_EQ(text(), broken);
}

TEST_F(ViewChoicesFile, a_newer_file_stays_as_it_is) {
    std::filesystem::create_directory(folder.file("steplab"));
    const std::string newer = "version = 2\nscale = 1.5\n";
    const ReadViewChoices read = read_text(newer);
    EXPECT_TRUE(read.newer);
    EXPECT_TRUE(read.problem);
    EXPECT_EQ(read.choices.scale, 1);
    remember_view_choices(path, {}, other_choices());
    EXPECT_EQ(text(), newer);
}

TEST_F(ViewChoicesFile, a_folder_in_its_place_is_no_error) {
    std::filesystem::create_directories(path);
    EXPECT_TRUE(read_view_choices(path).problem);
}

/// An environment variable with another value until the end of the block.
class WithVariable {
public:
    WithVariable(const char* name, const char* value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        value ? setenv(name, value, 1) : unsetenv(name);
    }
    ~WithVariable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
    WithVariable(const WithVariable&) = delete;
    WithVariable& operator=(const WithVariable&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(ViewChoicesPath, follows_the_base_directory_specification) {
    const WithVariable home("HOME", "/folder/x");
    {
        const WithVariable config("XDG_CONFIG_HOME", "/etc/other");
        EXPECT_EQ(view_choices_path(""), "/etc/other/steplab/view.toml");
        EXPECT_EQ(view_choices_path("none"), "");
        EXPECT_EQ(view_choices_path("my.toml"), "my.toml");
    }
    for (const char* unusable : {static_cast<const char*>(nullptr), "", "relative"}) {
        const WithVariable config("XDG_CONFIG_HOME", unusable);
        EXPECT_EQ(view_choices_path(""), "/folder/x/.config/steplab/view.toml");
        const WithVariable no_home("HOME", nullptr);
        EXPECT_EQ(view_choices_path(""), "");
    }
}

}  // namespace
}  // namespace steplab
