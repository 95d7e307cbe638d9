#include "io/files.hpp"

#include "app/program.hpp"
#include "app/tables.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace steplab {
namespace {

using testing::HasSubstr;

const std::vector<std::string> short_run{"run", "--model", "oscillator", "--steps", "3"};
/// Would take days and fill every disk unless it is stopped.
const std::vector<std::string> endless_run{"run", "--model", "chain", "--steps", "1e14", "--every", "1"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Files, closed_reader_ends_the_run_quietly) {
    RunningProgram run(with(endless_run, {"--out", "-"}));
    EXPECT_THAT(run.read_some(), testing::StartsWith("step,time,particle"));
    run.close_output();
    const Outcome outcome = run.wait();
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST(Files, closed_reader_ends_lists_and_helps_quietly) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"list"}, {"--help"}, {"run", "--help"}}) {
        RunningProgram list(words);
        list.close_output();
        EXPECT_EQ(list.wait().signal, 0);
    }
}

TEST(Files, standard_output_that_cannot_be_written_is_an_error) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"list"},
                                                  {"list", "--json"},
                                                  {"--help"},
                                                  {"--version"},
                                                  {"run", "--help"},
                                                  short_run,
                                                  with(short_run, {"--out", "-"}),
                                                  with(short_run, {"--summary", "-"})}) {
        const Outcome full = run_program(words, {.standard_output = "/dev/full"});
        EXPECT_EQ(full.code, 3) << testing::PrintToString(words);
        EXPECT_THAT(full.err, HasSubstr("cannot write standard output: No space left on device"));
        const Outcome closed = run_program(words, {.standard_output_closed = true});
        EXPECT_EQ(closed.code, 3) << testing::PrintToString(words);
        EXPECT_THAT(closed.err, HasSubstr("cannot write standard output"));
    }
}

TEST(Files, closed_standard_output_is_not_mistaken_for_the_file_that_is_opened_next) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.csv");
    EXPECT_EQ(run_program(with(short_run, {"--out", file}), {.standard_output_closed = true}).code, 3);
    EXPECT_THAT(text_of(file), testing::Not(HasSubstr("oscillator with")));
}

TEST(Files, full_disk_leaves_everything_as_it_was) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.csv");
    put_text(file, "as it was\n");
    // A limit on the size of files in place of a full disk: writing fails in the middle, too.
    const Outcome outcome = run_program({"run", "--set", "dim=100", "--every", "1", "--steps", "9", "--out", file},
                                        {.largest_file = 300000});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("cannot write '" + file + "': File too large"));
    EXPECT_EQ(text_of(file), "as it was\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Files, file_is_replaced_whole_and_keeps_its_permissions) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.csv");
    put_text(file, std::string(100000, 'x'));
    chmod(file.c_str(), 0640);
    ASSERT_EQ(run_program(with(short_run, {"--out", file})).code, 0);
    EXPECT_EQ(table(text_of(file)).rows.size(), 4u);
    struct stat status {};
    stat(file.c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(Files, links_are_followed) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("data"));
    std::filesystem::create_symlink("data/a.csv", folder.file("link.csv"));
    for (int time = 0; time < 2; ++time) {  // the file is not there yet, then it is
        ASSERT_EQ(run_program(with(short_run, {"--out", folder.file("link.csv")})).code, 0);
        EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.csv")));
        EXPECT_EQ(table(text_of(folder.file("data/a.csv"))).rows.size(), 4u);
    }
}

TEST(Files, one_file_by_two_names_is_wrong_use) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("a.csv", folder.file("link.csv"));
    const auto both = with(short_run, {"--out", "link.csv", "--series", "a.csv"});
    EXPECT_EQ(run_program(both, {.folder = folder.path()}).code, 2);
    put_text(folder.file("a.csv"), "");
    EXPECT_EQ(run_program(both, {.folder = folder.path()}).code, 2);
    const auto shell = with(short_run, {"--out", "-", "--series", "a.csv"});  // steplab run ... > a.csv
    EXPECT_EQ(run_program(shell, {.folder = folder.path(), .standard_output = folder.file("a.csv")}).code, 2);
}

TEST(Files, named_pipes_are_written_directly) {
    const TemporaryFolder folder;
    const std::string pipe = folder.file("rows");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    RunningProgram run(with(short_run, {"--out", pipe}));
    EXPECT_EQ(table(text_of(pipe)).rows.size(), 4u);
    EXPECT_EQ(run.wait().code, 0);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

/// Starts an endless run that writes `rows`, and waits until its other output shows that it has written much.
class Interrupted : public testing::TestWithParam<int> {
protected:
    Outcome interrupt_after_some_rows(const std::string& rows) {
        RunningProgram run(with(endless_run, {"--out", rows, "--series", "/dev/stdout"}));
        for (std::size_t read = 0; read < 1000000;) read += run.read_some().size();
        run.send(GetParam());
        return run.wait();
    }
    TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(By, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

TEST_P(Interrupted, run_keeps_whole_lines_beside_the_file) {
    const std::string file = folder_.file("a.csv");
    put_text(file, "as it was\n");
    const Outcome outcome = interrupt_after_some_rows(file);
    EXPECT_EQ(outcome.code, 128 + GetParam());
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_THAT(outcome.err, HasSubstr("'" + file + ".partial'"));
    EXPECT_EQ(text_of(file), "as it was\n");
    const std::string kept = text_of(file + ".partial");
    EXPECT_TRUE(kept.ends_with('\n'));
    const CsvTable csv = table(kept);
    ASSERT_GT(csv.rows.size(), 10000u);
    EXPECT_EQ(csv.rows.size() % 10, 0u);  // even whole frames
    for (const auto& row : csv.rows) ASSERT_EQ(row.size(), 9u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 2);
}

TEST_P(Interrupted, run_keeps_its_lines_whatever_signals_follow) {
    const std::string file = folder_.file("a.csv");
    for (const int second : {SIGINT, SIGTERM, SIGHUP}) {
        RunningProgram run(with(endless_run, {"--out", file, "--series", "/dev/stdout"}));
        for (std::size_t read = 0; read < 1000000;) read += run.read_some().size();
        for (const int signal : {GetParam(), second, second}) run.send(signal);
        const Outcome outcome = run.wait();
        EXPECT_EQ(outcome.signal, 0);
        EXPECT_THAT(outcome.code, testing::AnyOf(128 + GetParam(), 128 + second));  // they may come at once
        EXPECT_FALSE(std::filesystem::exists(file));
        EXPECT_GT(table(text_of(file + ".partial")).rows.size(), 10000u);
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1) << "no hidden file";
    }
}

TEST_P(Interrupted, run_without_files_just_ends) {
    const Outcome outcome = interrupt_after_some_rows("/dev/null");
    EXPECT_EQ(outcome.code, 128 + GetParam());
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_P(Interrupted, run_whose_reader_sleeps_ends_too) {
    RunningProgram run(with(endless_run, {"--out", "-"}));
    EXPECT_FALSE(run.read_some().empty());  // it has begun; from now on it waits for a reader of the pipe
    run.send(GetParam());
    EXPECT_EQ(run.wait().code, 128 + GetParam());
}

}  // namespace
}  // namespace steplab
