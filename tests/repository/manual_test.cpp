#include "completion.hpp"
#include "described_command.hpp"
#include "io/temporary_folder.hpp"
#include "man_page.hpp"
#include "shell.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <string>

namespace steplab::manual {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Manual, has_every_option_of_every_command) {
    const auto commands = described_commands();
    ASSERT_GT(commands.size(), 10u);
    for (const DescribedCommand& command : commands) {
        const std::string page = man_page(command, "steplab " + command.name);
        EXPECT_GT(command.options.size(), 1u) << command.name;
        for (const DescribedOption& option : command.options) {
            EXPECT_THAT(page, HasSubstr(escaped(option.names.back()))) << command.name;
            EXPECT_THAT(page, HasSubstr(escaped(option.what))) << command.name;
        }
        EXPECT_THAT(man_page(commands), HasSubstr("steplab\\-" + escaped(command.name)));
    }
    EXPECT_THAT(man_page(commands), Not(HasSubstr("no-such-command")));
}

TEST(Manual, shows_texts_as_they_are) {
    EXPECT_EQ(escaped("--a \\ \"b\""), "\\-\\-a \\e \\(dqb\\(dq");
    EXPECT_EQ(escaped(".x"), "\\&.x");
    EXPECT_EQ(escaped("x.y"), "x.y");
}

TEST(Manual, words_of_an_option_are_those_of_its_placeholder) {
    const auto words = [](const std::string& placeholder) {
        return DescribedOption{.names = {"--x"}, .placeholder = placeholder, .what = {}, .group = {}}.words();
    };
    EXPECT_THAT(words("float|double"), ElementsAre("float", "double"));
    EXPECT_THAT(words("ID|all"), ElementsAre("all"));
    EXPECT_THAT(words("name"), IsEmpty());
}

/// A shell that has read the completion.
class Completion : public testing::Test {
protected:
    /// What bash offers for the last of these words.
    std::string offered(const std::string& words) const {
        std::ofstream(folder_.file("steplab")) << bash_completion(described_commands());
        const std::string command = fmt::format(
            "source steplab; COMP_WORDS=({}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _steplab; echo \" "
            "${{COMPREPLY[*]}} \" 2>&1",
            words);
        const auto outcome = docs::run(command, folder_.path(), folder_.path());
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        return outcome.output;
    }

private:
    TemporaryFolder folder_;
};

TEST_F(Completion, offers_commands_options_and_values) {
    EXPECT_EQ(offered("steplab ru"), " run \n");
    EXPECT_THAT(offered("steplab ''"), HasSubstr(" snapshot "));
    EXPECT_THAT(offered("steplab run --st"), HasSubstr(" --steps "));
    EXPECT_THAT(offered("steplab run --st"), Not(HasSubstr(" --out ")));
    EXPECT_EQ(offered("steplab run --model cha"), " chain \n");
    EXPECT_EQ(offered("steplab limits --method rk"), " rk4 rkn-12-10 \n");
    EXPECT_EQ(offered("steplab run --precision ''"), " float double \n");
    EXPECT_EQ(offered("steplab run --scene figure"), " figure-eight \n");
}

TEST_F(Completion, offers_files_where_one_is_named) {
    EXPECT_EQ(offered("steplab run --scene ./ste"), " ./steplab \n");
    EXPECT_EQ(offered("steplab run --out ste"), " steplab \n");
    EXPECT_EQ(offered("steplab run --steps ste"), "  \n");
}

TEST_F(Completion, offers_what_follows_a_command) {
    EXPECT_THAT(offered("steplab list ''"), HasSubstr(" methods "));
    EXPECT_THAT(offered("steplab list ''"), HasSubstr(" --json "));
    EXPECT_EQ(offered("steplab convert ste"), " steplab \n");
    EXPECT_EQ(offered("steplab run ste"), "  \n");
}

TEST_F(Completion, knows_the_options_of_the_window) {
    EXPECT_THAT(offered("steplab-view --full"), HasSubstr("--full-screen"));
    EXPECT_THAT(offered("steplab --full"), HasSubstr("--full-screen"));
    EXPECT_EQ(offered("steplab-view --model rop"), " rope \n");
}

}  // namespace
}  // namespace steplab::manual
