#include "io/file_watch.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

namespace steplab {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// A file in a folder of its own, and a watch on it.
class Watched : public testing::Test {
protected:
    Watched() : file(folder.file("scene.toml")) { write(file, "one"); }
    TemporaryFolder folder;
    const fs::path file;
};

TEST_F(Watched, untouched_file_has_not_changed) {
    FileWatch watch({file});
    EXPECT_FALSE(watch.changed());
    EXPECT_FALSE(watch.changed());
}

TEST_F(Watched, file_written_in_place_has_changed_once) {
    FileWatch watch({file});
    write(file, "three");
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.changed());
}

// Of the same length: only the time tells.
TEST_F(Watched, time_stamp_alone_is_noticed) {
    FileWatch watch({file});
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::nanoseconds(1000));
    EXPECT_TRUE(watch.changed());
}

// Many editors write a new file and give it the name of the old one, with its time.
TEST_F(Watched, replaced_file_has_changed) {
    FileWatch watch({file});
    const fs::path other = folder.file("other");
    write(other, "two");
    fs::last_write_time(other, fs::last_write_time(file));
    fs::rename(other, file);
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.changed());
}

TEST_F(Watched, missing_file_has_not_changed_until_it_is_back) {
    FileWatch watch({file});
    fs::rename(file, folder.file("away"));
    EXPECT_FALSE(watch.changed());
    write(file, "two");
    EXPECT_TRUE(watch.changed());
}

TEST_F(Watched, any_of_several_files_counts) {
    const fs::path start = folder.file("start.xyz");
    FileWatch watch({file, start});
    write(start, "1");
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(FileWatch().changed());
}

}  // namespace
}  // namespace steplab
