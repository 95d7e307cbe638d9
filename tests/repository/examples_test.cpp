#include "io/temporary_folder.hpp"
#include "repository/files.hpp"
#include "sections.hpp"
#include "shell.hpp"

#include <gtest/gtest.h>

namespace steplab::repository {
namespace {

constexpr int no_opengl = 5;

/// Whether an example opens the window: it can only be shown to be understood here, where no display is.
bool opens_window(const std::string& command) {
    return command.starts_with("steplab view") || command.starts_with("steplab-view") ||
           command.starts_with("steplab --") || command == "steplab";
}

/// What an example of the documentation must end with in this build.
int expected_code(const std::string& command) {
#ifdef STEPLAB_GRAPHICS
    return opens_window(command) ? no_opengl : 0;
#else
    const bool draws = command.starts_with("steplab snapshot") || command.find("steplab record") != std::string::npos;
    return opens_window(command) || draws ? no_opengl : 0;
#endif
}

/// The examples of a page.
struct PageOfExamples {
    std::string page;
    std::vector<std::string> commands;

    friend std::ostream& operator<<(std::ostream& out, const PageOfExamples& examples) { return out << examples.page; }
};

std::vector<PageOfExamples> pages_with_examples() {
    std::vector<PageOfExamples> found;
    for (const TextFile& file : pages(STEPLAB_SOURCE_DIR)) {
        const std::vector<std::string> commands = docs::examples(file.text);
        if (!commands.empty()) found.push_back({file.path.string(), commands});
    }
    return found;
}

class ExamplesOf : public testing::TestWithParam<PageOfExamples> {};

// One after the other in one folder, as somebody who reads the page would.
TEST_P(ExamplesOf, the_documentation_do_what_they_say) {
    const TemporaryFolder folder;
    for (const std::string& command : GetParam().commands) {
        const auto outcome = docs::run(command + " 2>&1", folder.path(), std::string(STEPLAB_BINARY_DIR) + "/bin");
        EXPECT_EQ(outcome.code, expected_code(command)) << command << '\n' << outcome.output;
    }
}

INSTANTIATE_TEST_SUITE_P(Docs, ExamplesOf, testing::ValuesIn(pages_with_examples()),
                         [](const auto& test) { return name_in_tests(test.param.page); });

TEST(Examples, wrong_example_fails) {
    const TemporaryFolder folder;
    const auto outcome =
        docs::run("steplab run --model no-such 2>&1", folder.path(), std::string(STEPLAB_BINARY_DIR) + "/bin");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
}

}  // namespace
}  // namespace steplab::repository
