#include "io/child_program.hpp"

#include "core/interruption.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>

namespace steplab {
namespace {

using Input = ChildProgram::Input;
using End = ChildProgram::End;

TEST(ChildProgram, tells_how_it_ended_and_what_it_said) {
    EXPECT_EQ(ChildProgram({"true"}).end(), End::done);
    EXPECT_EQ(ChildProgram({"sh", "-c", "kill -TERM $$"}).end(), End::failed);
    ChildProgram failing({"sh", "-c", "echo unseen; echo 'no paper' >&2; exit 3"});
    EXPECT_EQ(failing.end(), End::failed);
    EXPECT_EQ(failing.messages(), "no paper");
}

TEST(ChildProgram, that_does_not_exist_is_missing) {
    ChildProgram missing({"no-such-program"}, Input::from_here);
    EXPECT_TRUE(missing.is_missing());
    EXPECT_EQ(missing.end(), End::missing);
    EXPECT_EQ(ChildProgram({"sh", "-c", "no-such-program"}).end(), End::missing);
}

TEST(ChildProgram, gets_all_bytes) {
    const TemporaryFolder folder;
    const std::string bytes(3'000'000, 'x');  // more than a pipe holds
    ChildProgram copy({"sh", "-c", "cat >\"$0\"", folder.file("a")}, Input::from_here);
    EXPECT_TRUE(copy.write(bytes));
    EXPECT_TRUE(copy.write("end"));
    EXPECT_EQ(copy.end(), End::done);
    EXPECT_EQ(text_of(folder.file("a")), bytes + "end");
    EXPECT_EQ(ChildProgram({"cat"}).end(), End::done) << "without input it does not wait for any";
}

TEST(ChildProgram, writes_the_file_that_it_is_given_even_if_its_name_is_gone) {
    const TemporaryFolder folder;
    std::FILE* const file = std::fopen(folder.file("a").c_str(), "w+");
    std::filesystem::remove(folder.file("a"));
    ChildProgram echo({"sh", "-c", "echo here >$0", ChildProgram::given_file}, Input::nothing, fileno(file));
    EXPECT_EQ(echo.end(), End::done);
    EXPECT_TRUE(folder.empty());
    std::array<char, 10> text{};
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), 5u);
    EXPECT_STREQ(text.data(), "here\n");
    std::fclose(file);
}

TEST(ChildProgram, that_reads_no_more_ends_the_writing) {
    std::signal(SIGPIPE, SIG_IGN);  // as prepare_standard_streams() does
    ChildProgram closed({"sh", "-c", "exit 1"}, Input::from_here);
    EXPECT_FALSE(closed.write(std::string(3'000'000, 'x')));
    EXPECT_EQ(closed.end(), End::failed);
    std::signal(SIGPIPE, SIG_DFL);
}

TEST(ChildProgram, that_does_not_read_or_end_can_be_interrupted) {
    const std::atomic<bool> asked = true;
    const InterruptibleBy interruption(asked);
    ChildProgram sleeper({"sleep", "1000"}, Input::from_here);
    EXPECT_THROW(sleeper.write(std::string(3'000'000, 'x')), Interrupted);
    EXPECT_THROW(sleeper.end(), Interrupted);
}

}  // namespace
}  // namespace steplab
