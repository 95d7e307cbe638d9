#include "io/temporary_folder.hpp"
#include "shell.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace steplab::repository {
namespace {

using testing::HasSubstr;

/// The program as `cmake --install` leaves it in a folder of its own.
class Installed : public testing::Test {
protected:
    void SetUp() override {
        const auto outcome = run(fmt::format("cmake --install '{}' --prefix '{}' 2>&1", STEPLAB_BINARY_DIR, prefix()));
        ASSERT_EQ(outcome.code, 0) << outcome.output;
    }

    std::string prefix() const { return folder_.file("prefix"); }
    std::filesystem::path file(const std::string& name) const { return std::filesystem::path(prefix()) / name; }
    /// Runs a command from another working directory, with the installed programs first in PATH.
    docs::Outcome run(const std::string& command) const { return docs::run(command, folder_.path(), file("bin")); }

private:
    TemporaryFolder folder_;
};

TEST_F(Installed, program_lists_models_from_anywhere) {
    const auto outcome = run("command -v steplab && steplab list models 2>&1");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(file("bin/steplab").string()));
    EXPECT_THAT(outcome.output, HasSubstr("chain"));
}

#ifdef STEPLAB_GRAPHICS
TEST_F(Installed, program_draws_from_anywhere) {
    const auto outcome =
        run("steplab snapshot --model chain --size 160x120 --out a.png 2>&1 && head -c 8 a.png | od -An -c");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("P   N   G"));
}

TEST_F(Installed, program_reads_the_installed_shaders) {
    const std::string shaders = file("share/steplab/shaders").string();
    const auto outcome = run("for file in '" + shaders + "'/*; do echo broken > \"$file\"; done;" +
                             "steplab snapshot --model chain --size 160x120 --out a.png 2>&1");
    EXPECT_EQ(outcome.code, 5);
    EXPECT_THAT(outcome.output, HasSubstr(shaders));
}

TEST_F(Installed, shaders_desktop_entry_and_icon_are_there) {
    EXPECT_FALSE(std::filesystem::is_empty(file("share/steplab/shaders")));
    EXPECT_TRUE(std::filesystem::exists(file("share/applications/steplab.desktop")));
    EXPECT_TRUE(std::filesystem::exists(file("share/icons/hicolor/scalable/apps/steplab.svg")));
    EXPECT_TRUE(std::filesystem::exists(file("bin/steplab-view")));
}

TEST_F(Installed, program_links_no_opengl) {
    const auto outcome = run("ldd \"$(command -v steplab)\"");
    EXPECT_EQ(outcome.code, 0);
    for (const char* library : {"libGL", "libOSMesa", "libEGL", "libX11", "libglfw"}) {
        EXPECT_THAT(outcome.output, testing::Not(HasSubstr(library)));
    }
}
#endif

}  // namespace
}  // namespace steplab::repository
