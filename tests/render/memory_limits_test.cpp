// Pictures where the system grants little memory.
#include "app/orderly_end.hpp"
#include "io/files.hpp"

#include <filesystem>
#include <string>

namespace steplab {
namespace {

// Mesa dies where memory is refused to it: steplab refuses to draw before that.
TEST(MemoryLimits, end_pictures_orderly) {
    const TemporaryFolder folder;
    const std::string picture = folder.file("a.png");
    for (const std::string size : {"320x240", "1920x1080"}) {
        int drawn = 0;
        for (unsigned long megabytes = least_megabytes(); megabytes < 1100; megabytes += 20) {
            std::filesystem::remove(picture);
            const Outcome outcome = run_program({"snapshot", "--model", "chain", "--size", size, "--out", picture},
                                                {.most_memory = megabytes << 20});
            expect_orderly_end(outcome, size + " at " + std::to_string(megabytes) + " MB");
            EXPECT_EQ(std::filesystem::exists(picture), outcome.code == 0);
            drawn += outcome.code == 0 ? 1 : 0;
            EXPECT_TRUE(outcome.code == 0 || megabytes < 1000) << outcome.err;
        }
        EXPECT_GT(drawn, 0) << size;
    }
}

TEST(MemoryLimits, end_films_orderly) {
    const TemporaryFolder folder;
    const std::string film = folder.file("a.gif");
    int drawn = 0;
    for (unsigned long megabytes = least_megabytes(); megabytes < 1100; megabytes += 60) {
        std::filesystem::remove(film);
        Outcome outcome = run_program(
            {"record", "--model", "chain", "--size", "320x240", "--steps", "2", "--fps", "10", "--out", film},
            {.most_memory = megabytes << 20});
        // ffmpeg has no more memory than the program that starts it
        if (outcome.err.find("ffmpeg") != std::string::npos) outcome.err = "steplab record: ffmpeg failed\n";
        expect_orderly_end(outcome, "a film at " + std::to_string(megabytes) + " MB");
        EXPECT_EQ(std::filesystem::exists(film), outcome.code == 0);
        drawn += outcome.code == 0 ? 1 : 0;
    }
    EXPECT_GT(drawn, 0);
    std::filesystem::remove(film);
    EXPECT_TRUE(folder.empty());
}

}  // namespace
}  // namespace steplab
