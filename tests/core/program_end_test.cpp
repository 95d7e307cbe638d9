#include "core/program_end.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace steplab::test {
namespace {

using AtEnd = UnfinishedFile::AtEnd;

/// A folder with the hidden file of a program that ends in the middle. That is a process of its own.
class ProgramEndDeathTest : public testing::Test {
protected:
    ProgramEndDeathTest() {
        std::string name = testing::TempDir() + "/steplab-end-XXXXXX";
        folder_ = mkdtemp(name.data());
    }
    ~ProgramEndDeathTest() override { std::filesystem::remove_all(folder_); }

    std::string hidden() const { return folder_ + "/hidden"; }
    std::string kept() const { return folder_ + "/kept"; }

    void end_while_writing(const std::string& text, AtEnd at_end) const {
        const int descriptor = open(hidden().c_str(), O_RDWR | O_CREAT, 0600);
        if (write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::_Exit(1);
        const UnfinishedFile unfinished(descriptor, hidden(), at_end, kept());
        end_program(7);
    }

    static std::string text_of(const std::string& name) {
        std::ostringstream text;
        text << std::ifstream(name).rdbuf();
        return text.str();
    }

private:
    std::string folder_;
};

TEST_F(ProgramEndDeathTest, removes_what_is_not_to_be_kept) {
    EXPECT_EXIT(end_while_writing("some", AtEnd::removed), testing::ExitedWithCode(7), "^$");
    EXPECT_FALSE(std::filesystem::exists(hidden()));
    EXPECT_FALSE(std::filesystem::exists(kept()));
}

TEST_F(ProgramEndDeathTest, keeps_all_that_was_written) {
    EXPECT_EXIT(end_while_writing("some\nthing", AtEnd::kept), testing::ExitedWithCode(7), "kept in '.*kept'");
    EXPECT_FALSE(std::filesystem::exists(hidden()));
    EXPECT_EQ(text_of(kept()), "some\nthing");
}

TEST_F(ProgramEndDeathTest, keeps_whole_lines) {
    const std::string lines = "first\n" + std::string(10000, 'x') + "\n";  // the last of them longer than a block
    EXPECT_EXIT(end_while_writing(lines + std::string(9000, 'y'), AtEnd::kept_in_lines), testing::ExitedWithCode(7),
                "kept");
    EXPECT_EQ(text_of(kept()), lines);
}

TEST_F(ProgramEndDeathTest, keeps_nothing_of_which_no_line_is_whole) {
    EXPECT_EXIT(end_while_writing("some", AtEnd::kept_in_lines), testing::ExitedWithCode(7), "^$");
    EXPECT_FALSE(std::filesystem::exists(hidden()));
    EXPECT_FALSE(std::filesystem::exists(kept()));
}

TEST_F(ProgramEndDeathTest, leaves_finished_files_alone) {
    const auto finish_and_end = [this] {
        { const UnfinishedFile finished(open(hidden().c_str(), O_RDWR | O_CREAT, 0600), hidden(), AtEnd::removed, ""); }
        end_program(7);
    };
    EXPECT_EXIT(finish_and_end(), testing::ExitedWithCode(7), "");
    EXPECT_TRUE(std::filesystem::exists(hidden()));
}

}  // namespace
}  // namespace steplab::test
