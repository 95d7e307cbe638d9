#include "io/temporary_folder.hpp"
#include "sections.hpp"
#include "shell.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace steplab::repository {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The relative links of a page that lead to no file.
std::vector<std::string> broken_links(const fs::path& page) {
    std::vector<std::string> links = docs::linked_files(text_of(page));
    std::erase_if(links, [&](const std::string& link) { return fs::exists(page.parent_path() / link); });
    return links;
}

/// The program as `cmake --install` leaves it in a folder of its own.
class Installed : public testing::Test {
protected:
    void SetUp() override {
        const auto outcome = run(fmt::format("cmake --install '{}' --prefix '{}' 2>&1", STEPLAB_BINARY_DIR, prefix()));
        ASSERT_EQ(outcome.code, 0) << outcome.output;
    }

    std::string prefix() const { return folder_.file("prefix"); }
    fs::path file(const std::string& name) const { return fs::path(prefix()) / name; }
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

TEST_F(Installed, lessons_are_where_the_program_finds_them) {
    EXPECT_TRUE(fs::exists(file("share/steplab/lessons/one-step.toml")));
    EXPECT_TRUE(fs::exists(file("share/steplab/lessons/one-step.session")));
    const auto outcome = run("steplab replay --lesson one-step 2>&1");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
}

TEST_F(Installed, program_has_the_version_of_the_newest_release) {
    const std::string changes = text_of(file("share/doc/steplab/CHANGELOG.md"));
    const auto outcome = run("steplab --version");
    ASSERT_TRUE(outcome.output.starts_with("steplab ")) << outcome.output;
    const std::string version = outcome.output.substr(8, outcome.output.find('\n') - 8);
    const std::size_t release = changes.find("\n## ", changes.find("\n## Unreleased") + 1);
    ASSERT_NE(release, std::string::npos);
    EXPECT_TRUE(changes.substr(release).starts_with("\n## " + version + " ("));
}

TEST_F(Installed, links_of_all_pages_lead_to_installed_files) {
    EXPECT_GT(docs::linked_files(text_of(file("share/doc/steplab/README.md"))).size(), 10u);
    for (const auto& entry : fs::recursive_directory_iterator(file("share/doc/steplab"))) {
        if (entry.path().extension() != ".md") continue;
        EXPECT_THAT(broken_links(entry.path()), IsEmpty()) << entry.path();
    }
}

TEST_F(Installed, link_to_a_missing_file_is_found) {
    const fs::path page = file("share/doc/steplab/page.md");
    std::ofstream(page) << "[there](docs/units.md), [also](README.md#models), [not there](missing.md)\n";
    EXPECT_THAT(broken_links(page), ElementsAre("missing.md"));
    fs::remove(file("share/doc/steplab/docs/units.md"));
    EXPECT_THAT(broken_links(page), ElementsAre("docs/units.md", "missing.md"));
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
    EXPECT_FALSE(fs::is_empty(file("share/steplab/shaders")));
    EXPECT_TRUE(fs::exists(file("share/applications/steplab.desktop")));
    EXPECT_TRUE(fs::exists(file("share/icons/hicolor/scalable/apps/steplab.svg")));
    EXPECT_TRUE(fs::exists(file("bin/steplab-view")));
    EXPECT_TRUE(fs::exists(file("share/steplab/pictures/chain.png")));
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
