#include "io/ordered_writer.hpp"

#include "core/error.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace steplab {
namespace {

TEST(OrderedWriter, keeps_the_order_of_blocks_whatever_time_they_take) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    std::string expected;
    {
        OrderedWriter writer(file);
        for (int i = 0; i < 500; ++i) {
            const std::string text = std::to_string(i) + ' ';
            expected += text;
            writer.submit([text, i](std::string& bytes, std::string&) {
                volatile double work = 0;  // the earlier of each seven take longer
                for (int j = 0; j < 3000 * (7 - i % 7); ++j) work = work + j;
                bytes = text;
            });
        }
        writer.drain();
    }
    file.commit();
    EXPECT_EQ(text_of(folder.file("a")), expected);
}

TEST(OrderedWriter, passes_on_what_the_file_throws) {
    OutputFile file("/dev/full");
    OrderedWriter writer(file);
    const auto write_all = [&] {
        for (int i = 0; i < 100; ++i)
            writer.submit([](std::string& bytes, std::string&) { bytes.assign(1000000, 'x'); });
        writer.drain();
    };
    EXPECT_THROW(write_all(), FileError);
}

TEST(OrderedWriter, writes_nothing_after_a_failure) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    OrderedWriter writer(file);
    writer.submit([](std::string& bytes, std::string&) { bytes = "begin"; });
    writer.drain();
    writer.submit([](std::string&, std::string&) { throw FileError("no more"); });
    EXPECT_THROW(writer.drain(), FileError);
    EXPECT_THROW(writer.submit([](std::string& bytes, std::string&) { bytes = "end"; }), FileError);
    file.commit();
    EXPECT_EQ(text_of(folder.file("a")), "begin");
}

TEST(OrderedWriter, holds_no_more_than_a_few_blocks) {
    OutputFile file("/dev/null");
    OrderedWriter writer(file);
    const auto held = std::make_shared<int>();
    long most = 0;
    for (int i = 0; i < 2000; ++i) {
        writer.submit([held](std::string& bytes, std::string&) { bytes.assign(20000, 'x'); });
        most = std::max(most, held.use_count() - 1);
    }
    EXPECT_LE(most, static_cast<long>(writer.most_blocks()));
    EXPECT_GT(most, 0);
    writer.drain();
    EXPECT_EQ(held.use_count(), 1);
}

TEST(OrderedWriter, ends_though_the_reader_of_a_pipe_sleeps) {
    const TemporaryFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int sleeper = open(pipe.c_str(), O_RDWR | O_CLOEXEC);  // a reader that never reads
    {
        OutputFile file(pipe);
        OrderedWriter writer(file);
        for (std::size_t i = 0; i + 1 < writer.most_blocks(); ++i)
            writer.submit([](std::string& bytes, std::string&) { bytes.assign(1000000, 'x'); });
    }
    close(sleeper);
}

}  // namespace
}  // namespace steplab
