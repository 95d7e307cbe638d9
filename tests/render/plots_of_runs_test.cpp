// The plots of pictures and films show every run.

#include "app/png.hpp"
#include "render/palette.hpp"
#include "render/record_test.hpp"

#include <algorithm>
#include <cstdlib>

namespace steplab {
namespace {

/// Pixels of the plots whose colour is that of a run or nearly so.
std::size_t pixels_of_run(const ReadPicture& picture, std::size_t run) {
    constexpr int near = 60;  // a channel: thin lines are mixed with their ground
    const render::Rgb colour = render::palette(Background::dark).runs[run];
    std::size_t found = 0;
    for (int y = picture.height * 3 / 4; y < picture.height; ++y) {
        for (int x = picture.width / 3; x < picture.width; ++x) {
            const auto* const pixel =
                picture.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                           static_cast<std::size_t>(x));
            found += std::max({std::abs(pixel[0] - colour.red), std::abs(pixel[1] - colour.green),
                               std::abs(pixel[2] - colour.blue)}) < near;
        }
    }
    return found;
}

class PlotsOfRuns : public Record, public testing::WithParamInterface<const char*> {
protected:
    /// What a plot shows of the second of these runs.
    std::size_t of_second(const Words& runs, const std::string& plot) const {
        const Words options{"--model", GetParam(), "--dt", "0.01", "--until", "0.5", "--ui", "on", "--plots", plot};
        EXPECT_EQ(snapshot(joined(joined(options, runs), {"--out", "a.png"})).code, 0);
        return pixels_of_run(read_png(file("a.png")), 1);
    }
};

TEST_P(PlotsOfRuns, have_a_curve_of_each) {
    const Words first{"--run", "method=rk4"}, alone_in_it{"--method", "rk4"};
    for (const char* const plot : {"energy-error", "position-error"}) {
        const std::size_t alone = of_second(alone_in_it, plot);
        // A curve across the plot is more than a hundred pixels; the sample of it in the legend is fewer.
        EXPECT_GT(of_second(joined(first, {"--run", "method=euler"}), plot), alone + 150) << plot;
        EXPECT_GT(of_second(joined(first, {"--run", "method=euler,dt=0.007"}), plot), alone + 150)
            << plot << ", with steps of its own";
    }
}

// Against the exact solution, and against a reference where there is none.
INSTANTIATE_TEST_SUITE_P(Scenes, PlotsOfRuns, testing::Values("chain", "morse"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace steplab
