// What becomes of a film of the window where a thread or memory is missing.
#include "app/film/film_recorder.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "support/allocations.hpp"
#include "support/no_threads.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace steplab::test {
namespace {

void nobody() {}

class FilmRecording : public testing::Test {
protected:
    FilmFormat format() const { return {folder_.file("%02d.png"), {4, 4}, 10}; }
    static Picture picture() { return {{4, 4}, std::vector<std::uint8_t>(64, 200), {}}; }
    TemporaryFolder folder_;
};

TEST_F(FilmRecording, writes_each_frame) {
    FilmRecorder recorder(format(), nobody);
    recorder.add(picture(), 1);
    recorder.finish();
    EXPECT_EQ(recorder.failure(), "");
    EXPECT_TRUE(std::filesystem::exists(folder_.file("00.png")));
}

TEST_F(FilmRecording, is_refused_without_a_thread) {
    const NoThreads none;
    EXPECT_THROW(FilmRecorder(format(), nobody), UsageError);
    EXPECT_TRUE(folder_.empty());
}

TEST_F(FilmRecording, ends_with_a_word_where_there_is_no_memory_for_one) {
    FilmRecorder recorder(format(), nobody);
    Picture frame = picture();
    {
        const NoMemoryElsewhere none;
        recorder.add(std::move(frame), 1);
        recorder.finish();
    }
    EXPECT_TRUE(recorder.is_over());
    EXPECT_EQ(recorder.failure(), "out of memory");
    EXPECT_TRUE(folder_.empty());
}

}  // namespace
}  // namespace steplab::test
