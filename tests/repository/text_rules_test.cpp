#include "repository/text_rules.hpp"

#include <gmock/gmock.h>

namespace steplab::repository {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<TextFile>& repository() {
    static const std::vector<TextFile> files = text_files(STEPLAB_SOURCE_DIR);
    return files;
}

TEST(Text, speaks_of_no_machine_and_puts_nothing_off) { EXPECT_THAT(unwanted_words(repository()), IsEmpty()); }

TEST(Text, unwanted_words_are_found) {
    EXPECT_THAT(unwanted_words({{"a.cpp", std::string("int x;\n// TO") + "DO: later\n"}}), SizeIs(1));
    EXPECT_THAT(unwanted_words({{"a.md", std::string("see /ho") + "me/me/steplab\n"}}), SizeIs(1));
    EXPECT_THAT(unwanted_words({{"a.cpp", "const auto name = \"file-XXXXXX\";\n"}}), IsEmpty());
}

TEST(Text, every_test_runs) { EXPECT_THAT(tests_that_may_not_run(repository()), IsEmpty()); }

TEST(Text, tests_that_may_not_run_are_found) {
    EXPECT_THAT(tests_that_may_not_run({{"a_test.cpp", std::string("TEST(A, DISABL") + "ED_b) {}\n"}}), SizeIs(1));
}

TEST(Text, sources_stay_short) { EXPECT_THAT(long_sources(repository()), IsEmpty()); }

TEST(Text, long_source_is_found) {
    std::string text;
    for (int line = 0; line < 351; ++line) text += "\n";
    EXPECT_THAT(long_sources({{"a.cpp", text}}), ElementsAre("a.cpp: 351"));
}

TEST(Text, scripts_and_only_scripts_have_the_run_bit) { EXPECT_THAT(wrong_run_bits(repository()), IsEmpty()); }

TEST(Text, wrong_run_bits_are_found) {
    EXPECT_THAT(
        wrong_run_bits({{"a.sh", "#!/bin/sh\n", false}, {"b.txt", "words\n", true}, {"c.sh", "#!/bin/sh\n", true}}),
        ElementsAre("a.sh", "b.txt"));
}

TEST(Text, interface_makes_no_scene) { EXPECT_THAT(scenes_made_by_the_interface(repository()), IsEmpty()); }

TEST(Text, scenes_of_the_interface_are_found) {
    const std::string lines =
        "model(id).plan(values);\nstability_limit(description);\ncheck(description);\nentry->omega_max(values);\n"
        "interface.scene();\ncheck_values(description);\nview.resolution.error;\nfacts_of(description).drag;\nview."
        "facts.drag;\n";
    EXPECT_THAT(scenes_made_by_the_interface({{"src/ui/panels/a.cpp", lines}, {"src/app/window/a.cpp", lines}}),
                SizeIs(10));
    EXPECT_THAT(scenes_made_by_the_interface({{"src/sim/run/a.cpp", lines}}), IsEmpty());
}

TEST(Text, programs_write_through_the_streams) { EXPECT_THAT(writing_past_the_streams(repository()), IsEmpty()); }

TEST(Text, writing_past_the_streams_is_found) {
    const std::string lines =
        "fmt::print(stderr, \"{}\", name);\nstd::fputs(name, stdout);\nstd::cerr << name;\nfmt::print(\"{}\", name);\n"
        "isatty(STDERR_FILENO);\nprint(name);\n";
    EXPECT_THAT(writing_past_the_streams({{"src/app/commands/a.cpp", lines}, {"src/app/cli/progress.cpp", lines}}),
                SizeIs(4));
    EXPECT_THAT(writing_past_the_streams({{"tests/app/a.cpp", lines}}), IsEmpty());
}

TEST(Text, lines_are_tidy) { EXPECT_THAT(untidy_lines(repository()), IsEmpty()); }

TEST(Text, untidy_lines_are_found) {
    EXPECT_THAT(untidy_lines({{"a.cpp", "int x; \n"}, {"b.cpp", "\tint x;\n"}, {"c.cpp", "int x;"}}), SizeIs(3));
    EXPECT_THAT(untidy_lines({{"a.md", "a line that is broken here  \n"}}), IsEmpty());
}

}  // namespace
}  // namespace steplab::repository
