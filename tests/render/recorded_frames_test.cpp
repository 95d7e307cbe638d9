#include "render/framing.hpp"
#include "render/record_test.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <ostream>

namespace steplab {
namespace {

/// A case in which a film is compared with snapshots.
struct Pictured {
    std::string name;
    Words options;
    int frames, steps_a_frame;

    friend std::ostream& operator<<(std::ostream& out, const Pictured& film) { return out << film.name; }
};

class RecordedFrames : public Record, public testing::WithParamInterface<Pictured> {};

TEST_P(RecordedFrames, are_the_bytes_of_snapshots) {
    const auto& [name, options, frames, steps] = GetParam();
    const Outcome outcome = record(joined(options, {"--out", "f%03d.png"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(files(), static_cast<std::size_t>(frames));
    for (int frame = 0; frame < frames; ++frame) {
        Words picture{"--steps", std::to_string(frame * steps), "--out", "snapshot.png"};
        for (std::size_t i = 0; i < options.size(); i += 2) {
            const std::string& option = options[i];
            if (option != "--until" && option != "--fps" && option != "--speed")
                picture = joined(picture, {option, options[i + 1]});
        }
        ASSERT_EQ(snapshot(picture).code, 0);
        EXPECT_TRUE(bytes(fmt::format("f{:03}.png", frame)) == bytes("snapshot.png")) << "frame " << frame;
    }
}

const Words small{"--size", "200x150"}, with_panel{"--ui", "on", "--size", "640x400"};
const Words chain_alone{"--model", "chain", "--view", "0,10,60,9,0,0"}, chain = joined(chain_alone, small);
const Words rope{"--model", "rope", "--until", "2", "--view", "0,0,30,5,-3,0"};
const Words two_runs{"--run", "method=rk4,dt=0.01", "--run", "method=euler,dt=0.05"};

INSTANTIATE_TEST_SUITE_P(
    Films, RecordedFrames,
    testing::Values(
        Pictured{"chain", joined(chain, {"--until", "2", "--fps", "10", "--speed", "4"}), 6, 4},
        Pictured{"backward", joined(chain, {"--dt", "-0.1", "--until", "-1", "--fps", "5"}), 6, 2},
        Pictured{"float_run", joined(chain, {"--precision", "float", "--until", "5", "--fps", "1"}), 6, 10},
        Pictured{"adaptive", joined(chain, {"--method", "dopri5", "--until", "1", "--fps", "5"}), 6, 2},
        Pictured{"ghosts", joined(joined(rope, two_runs), {"--size", "300x200", "--fps", "2"}), 5, 50},
        Pictured{"split", joined(joined(rope, two_runs), {"--size", "300x200", "--fps", "2", "--layout", "split"}), 5,
                 50},
        Pictured{"ensemble", joined(chain, {"--until", "4", "--fps", "1", "--ensemble", "5", "--spread", "k=0.9:1.1"}),
                 5, 10},
        Pictured{"panel", joined(joined(chain_alone, with_panel), {"--until", "20", "--fps", "1", "--speed", "4"}), 6,
                 40},
        Pictured{"panel_of_runs", joined(joined(joined(rope, two_runs), with_panel), {"--fps", "2"}), 5, 50}),
    [](const auto& test) { return test.param.name; });

// Beyond 400 steps the plots of a film have the samples of its end from the beginning: no step is taken twice for them.
TEST_F(Record, last_frame_with_the_panel_is_a_snapshot_in_long_runs_too) {
    const Words options = joined(chain_alone, with_panel);
    ASSERT_EQ(record(joined(options, {"--until", "100", "--fps", "1", "--speed", "50", "--out", "%d.png"})).code, 0);
    ASSERT_EQ(snapshot(joined(options, {"--steps", "1000", "--out", "snapshot.png"})).code, 0);
    EXPECT_TRUE(bytes("2.png") == bytes("snapshot.png"));
}

TEST_F(Record, last_frame_at_a_shortened_step_is_a_snapshot) {
    const Words options = joined(chain, {"--method", "dopri5", "--until", "1.05"});
    ASSERT_EQ(record(joined(options, {"--fps", "20", "--out", "%02d.png"})).code, 0);
    ASSERT_EQ(snapshot(joined(options, {"--out", "snapshot.png"})).code, 0);
    EXPECT_TRUE(bytes("21.png") == bytes("snapshot.png"));
    EXPECT_FALSE(bytes("20.png") == bytes("snapshot.png"));
}

TEST_F(Record, has_the_same_bytes_each_time) {
    for (const char* name : {"a%02d.png", "b%02d.png"})
        ASSERT_EQ(record({"--until", "2", "--size", "160x120", "--out", name, "--fps", "5"}).code, 0);
    for (int i = 0; i <= 10; ++i)
        EXPECT_TRUE(bytes(fmt::format("a{:02}.png", i)) == bytes(fmt::format("b{:02}.png", i))) << i;
}

// Two particles that fly apart: a camera that followed the scene would go back.
TEST_F(Record, keeps_the_camera_of_its_first_frame) {
    const Words options{"--model", "free", "--set", "n=2", "--size", "200x150"};
    ASSERT_EQ(record(joined(options, {"--until", "40", "--fps", "1", "--speed", "20", "--out", "%d.png"})).code, 0);
    RunDescription description = describe("free");
    description.scene.set_text("n", "2");
    const render::Camera camera = render::default_camera(Simulation(description).frame(), {200, 150});
    const Words there = joined(options, {"--steps", "400", "--out"});
    ASSERT_EQ(snapshot(joined(there, {"same.png", "--view", render::view_text(camera)})).code, 0);
    ASSERT_EQ(snapshot(joined(there, {"framed.png"})).code, 0);
    EXPECT_TRUE(bytes("2.png") == bytes("same.png"));
    EXPECT_FALSE(bytes("2.png") == bytes("framed.png"));
}

}  // namespace
}  // namespace steplab
