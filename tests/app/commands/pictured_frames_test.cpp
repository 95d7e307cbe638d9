#include "app/commands/pictured_frames.hpp"

#include "io/temporary_folder.hpp"
#include "io/trajectories.hpp"
#include "sim/run/simulation.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace steplab {
namespace {

/// Every second step of the opening chain.
void write_chain(const std::string& path, TrajectoryFormat format) {
    const RunDescription run = describe("chain", "rk4");
    OutputFile file(path);
    TrajectoryWriter writer(file, format, run, {});
    Simulation simulation(run);
    for (int i = 0; i < 12; ++i) {
        Frame frame;
        simulation.frame(frame, {.displacements = true});
        writer.add(frame);
        simulation.advance(2);
    }
    writer.finish();
    file.commit();
}

TEST(PicturedFrames, tell_plots_of_all_frames_up_to_that_of_the_picture) {
    const TemporaryFolder folder;
    write_chain(folder.file("a.trajectory"), TrajectoryFormat::trajectory);
    write_chain(folder.file("a.xyz"), TrajectoryFormat::xyz);
    for (const char* const name : {"a.trajectory", "a.xyz"}) {
        PictureRequest picture;
        picture.panel = true;
        PicturedFrames frames(folder.file(name), std::move(picture));
        for (const std::uint64_t step : {8U, 9U, 22U}) {
            frames.go_to(RunEnd{.step = step});
            const auto& samples = frames.request().view.series.samples;
            ASSERT_EQ(samples.size(), step / 2 + 1) << name;
            EXPECT_EQ(samples.back().step, step / 2 * 2);
            EXPECT_TRUE(samples.back().particle());
        }
    }
}

TEST(PicturedFrames, without_panels_read_no_others) {
    const TemporaryFolder folder;
    write_chain(folder.file("a.trajectory"), TrajectoryFormat::trajectory);
    PicturedFrames frames(folder.file("a.trajectory"), {});
    frames.go_to(RunEnd{.step = 20});
    EXPECT_TRUE(frames.request().view.series.samples.empty());
}

}  // namespace
}  // namespace steplab
