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
    return opens_window(command) || command.starts_with("steplab snapshot") ? no_opengl : 0;
#endif
}

TEST(Examples, of_the_documentation_do_what_they_say) {
    const TemporaryFolder folder;
    std::size_t count = 0;
    for (const TextFile& file : text_files(STEPLAB_SOURCE_DIR)) {
        if (file.path.extension() != ".md") continue;
        for (const std::string& command : docs::examples(file.text)) {
            ++count;
            const auto outcome = docs::run(command + " 2>&1", folder.path(), std::string(STEPLAB_BINARY_DIR) + "/bin");
            EXPECT_EQ(outcome.code, expected_code(command)) << file.path << ": " << command << '\n' << outcome.output;
        }
    }
    EXPECT_GT(count, 5u);  // the examples were found
}

TEST(Examples, wrong_example_fails) {
    const TemporaryFolder folder;
    const auto outcome =
        docs::run("steplab run --model no-such 2>&1", folder.path(), std::string(STEPLAB_BINARY_DIR) + "/bin");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
}

}  // namespace
}  // namespace steplab::repository
