#include "core/error.hpp"
#include "io/carried_json.hpp"
#include "io/files.hpp"
#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "io/starting_values_file.hpp"
#include "io/trajectory.hpp"
#include "sim/run/simulation.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace steplab::test {
namespace {

using testing::HasSubstr;

constexpr int moving = 6;
const std::string between_walls = row_between_walls(moving) + "[run]\nmethod = \"taylor\"\n";

TEST(SceneStart, in_a_normal_mode_vibrates_with_its_frequency) {
    for (int mode = 1; mode <= moving; ++mode) {
        RunDescription run =
            describe(read_scene(between_walls + "[start]\nmode = " + std::to_string(mode) + "\namplitude = 1e-4\n"));
        const double phase = mode * std::numbers::pi / (2 * (moving + 1)), omega = 2 * 2 * std::sin(phase);
        const Start start = model_of(run).plan(run.scene).start;
        double largest = 0;
        for (int i = 1; i <= moving; ++i) {
            const Vec3 at = start[static_cast<std::size_t>(i)].displacement;
            largest = std::max(largest, length(at));
            EXPECT_NEAR(std::abs(at.x),
                        std::abs(start[1].displacement.x / std::sin(2 * phase) * std::sin(2 * phase * i)), 1e-12)
                << mode;
        }
        EXPECT_NEAR(largest, 1e-4, 1e-16);
        run.dt = 2 * std::numbers::pi / omega;
        run.method_parameters.set("tolerance", 1e-13);
        Simulation simulation(run);
        const State<double> before = simulation.state();
        simulation.advance(1);
        // the springs are linear along the line: one period brings it back but for the tolerance of the method
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_LT(length(simulation.state().displacement.at(i) - before.displacement.at(i)), 1e-12) << mode;
    }
}

TEST(SceneStart, in_a_mode_of_different_masses_leaves_the_centre_of_mass) {
    const std::string pair = R"(steplab = 1
[[particles]]
group = "a"
[[particles]]
group = "b"
position = [1, 0, 0]
mass = 3
[[springs]]
pairs = [["a", "b"]]
k = 1
[start]
mode = 1
amplitude = 0.3
)";
    const RunDescription run = describe(read_scene(pair));
    const Start start = model_of(run).plan(run.scene).start;
    EXPECT_NEAR(std::abs(start[0].displacement.x), 0.3, 1e-15);
    EXPECT_NEAR(start[0].displacement.x + 3 * start[1].displacement.x, 0, 1e-15);
    EXPECT_THAT(refusal_of_scene(pair.substr(0, pair.find("mode = 1")) + "mode = 2\namplitude = 0.3\n"),
                HasSubstr("there is no normal mode 2: the scene has 1 of a frequency > 0"));
}

TEST(SceneStart, that_is_wrong_is_refused_with_its_place) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"mode = 0\namplitude = 1", "a.toml:14:8: must be an integer from 1"},
        {"mode = 1", "a.toml:13:1: mode and amplitude belong together"},
        {"amplitude = 1", "a.toml:13:1: mode and amplitude belong together"},
        {"mode = 7\namplitude = 1", "there is no normal mode 7: the scene has 6"},
        {"reverse = 1", "a.toml:14:11: must be true or false"},
        {"from = \"a.csv\"", "a.toml:14:8: cannot read 'a.csv': the run does not carry it"},
        {"form = 1", "unknown key 'form' of [start] (did you mean 'from'?)"}};
    for (const auto& [block, message] : cases)
        EXPECT_THAT(refusal_of_scene(between_walls + "[start]\n" + block + "\n"), HasSubstr(message)) << block;
    EXPECT_THAT(refusal_of_scene("steplab = 1\n[[particles]]\nfixed = true\n[start]\nmode = 1\namplitude = 1\n"),
                HasSubstr("there is no normal mode 1: the scene has 0 of a frequency > 0"))
        << "nothing moves";
    std::string large = between_walls;
    large.replace(large.find("count = 8"), 9, "count = 301");
    EXPECT_THAT(refusal_of_scene(large + "[start]\nmode = 1\namplitude = 1\n"),
                HasSubstr("a.toml:14:8: normal modes are computed of at most 300 particles, the scene has 301"));
}

TEST(SceneStart, from_a_file_of_other_particles_is_refused_with_its_place) {
    const std::string few = "step,time,particle,x,y,z\n0,0,0,1,2,3\n0,0,1,1,2,3\n";
    try {
        scene_from(
            {{.name = "", .content = between_walls + "[start]\nfrom = \"a.csv\"\n"}, {.name = "a.csv", .content = few}},
            "a.toml");
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.toml:14:8: it holds 2 particles, the scene has 8"));
    }
}

TEST(SceneStart, from_a_trajectory_continues_its_run) {
    const TemporaryFolder folder;
    RunDescription run = describe(read_scene(between_walls + "[start]\nmode = 2\namplitude = 0.1\n"));
    run = with_method(run, "rk4");
    Simulation simulation(run);
    {
        OutputFile file(folder.file("run.trajectory"));
        TrajectoryWriter writer(file, TrajectoryFormat::trajectory, run);
        Frame frame;
        for (int i = 0; i < 4; ++i) {
            simulation.frame(frame, writer.needs());
            writer.add(frame);
            if (i < 3) simulation.advance(5);
        }
        writer.finish();
        file.commit();
    }
    for (const auto& [from, step] : {std::pair{"run.trajectory", 15}, {"run.trajectory:10", 10}}) {
        put_text(folder.file("a.toml"), between_walls + "[start]\nfrom = \"" + from + "\"\n");
        const SceneOrigin origin = read_scene_file(folder.file("a.toml"));
        RunDescription rest = with_method(describe(origin), "rk4");
        Simulation whole(run), second(rest);
        whole.advance(static_cast<std::uint64_t>(step) + 5);
        second.advance(5);
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_EQ(second.state().displacement.at(i), whole.state().displacement.at(i)) << from;
            EXPECT_EQ(second.state().velocity.at(i), whole.state().velocity.at(i)) << from;
        }
        EXPECT_EQ(origin_of(json_of(*origin)), origin);
        EXPECT_THAT(scene_file_text(rest), HasSubstr("[start]\nfrom = \"" + std::string(from) + "\""));
        const std::vector<SceneFile::Part>& parts = rest.origin->parts;
        std::vector<SceneFile::Part> carried{{.name = "", .content = scene_file_text(rest)}};
        carried.insert(carried.end(), parts.begin() + 1, parts.end());
        const SceneOrigin again = scene_from(carried, "b.toml");
        EXPECT_EQ(again->model->plan(rest.scene).start[3].displacement,
                  origin->model->plan(rest.scene).start[3].displacement);
    }
    put_text(folder.file("a.toml"), between_walls + "[start]\nfrom = \"run.trajectory:3\"\n");
    try {
        read_scene_file(folder.file("a.toml"));
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("it has no frame of step 3"));
    }
}

TEST(SceneStart, reversed_and_until_are_read_and_written) {
    const RunDescription run = describe(read_scene(
        between_walls +
        "until = 20\ncompare = [\"method=rk4,dt=0.02\", \"method=euler-forward\"]\n[start]\nreverse = true\n"));
    EXPECT_EQ(model_of(run).opening.until, 20);
    EXPECT_TRUE(model_of(run).scene(run.scene).start.change.reverse);
    const std::string text = scene_file_text(run);
    EXPECT_THAT(text, HasSubstr("until = 20\n"));
    EXPECT_THAT(text, HasSubstr("[start]\nreverse = true\n"));
    EXPECT_NO_THROW(read_scene(text));
}

TEST(SceneRun, compares_only_runs_that_there_can_be) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"[\"method=rk4\", \"method=rk5\"]", "a.toml:13:26: unknown method 'rk5'"},
        {"\"dt=0\"", "dt must be"},
        {"\"rk4\"", "'rk4' is not of the form name=value"},
        {"\"precision=half\"", "unknown precision 'half'"},
        {"\"method=rk4,tolerance=1\"", "unknown setting 'tolerance'"},
        {"\"method=dopri5,tolerance=1e-9\"", "read"}};
    for (const auto& [list, message] : cases)
        EXPECT_THAT(refusal_of_scene(between_walls + "compare = " + list + "\n"), HasSubstr(message)) << list;
    // the parameters of the scene are those of the runs, too
    const std::string with_speed =
        "steplab = 1\n[parameters]\nspeed = 1\n[[particles]]\nvelocity = [\"speed\", 0, 0]\n[run]\ncompare = ";
    EXPECT_EQ(refusal_of_scene(with_speed + "\"speed=2\"\n"), "read");
    EXPECT_THAT(refusal_of_scene(with_speed + "\"sped=2\"\n"), HasSubstr("did you mean 'speed'?"));
    const std::string one = "\"method=rk4\"", three = "[" + one + ", " + one + ", " + one;
    EXPECT_EQ(refusal_of_scene(between_walls + "compare = " + three + "]\n"), "read");
    EXPECT_THAT(refusal_of_scene(between_walls + "compare = " + three + ", " + one + "]\n"),
                HasSubstr("a.toml:13:11: at most 3 runs are compared with the first: these are 4"));
    // where no method is named, the first run is one of rk4, which has no tolerance
    const std::string unnamed = row_between_walls(moving) + "[run]\ncompare = ";
    EXPECT_EQ(refusal_of_scene(unnamed + "\"dt=0.05\"\n"), "read");
    EXPECT_THAT(refusal_of_scene(unnamed + "\"tolerance=1e-9\"\n"), HasSubstr("unknown setting 'tolerance'"));
    EXPECT_EQ(refusal_of_scene(replaced(unnamed, "compare", "method = \"dopri5\"\ncompare") + "\"tolerance=1e-9\"\n"),
              "read");
}

TEST(SceneRun, goes_backward_by_a_negative_dt) {
    const std::string run = row_between_walls(moving) + "[run]\n";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"dt = -0.01", "read"},
        {"dt = -0.01\nuntil = -2", "read"},
        {"until = 2", "read"},
        {"dt = 0", "a.toml:12:6: must not be 0"},
        {"until = 0", "a.toml:12:9: must not be 0"},
        {"dt = -0.01\nuntil = 2", "a.toml:13:9: until = 2 and dt = -0.01 differ in sign"},
        {"method = \"dopri5\"\ndt = -0.01", "a.toml:13:6: dopri5 chooses its own steps"},
        {"method = \"gauss-16\"\ndt = -0.01", "read"},
        {"method = \"gauss-16\"\nparameters = { tolerance = 1e-9 }\ndt = -0.01", "gauss-16 chooses its own steps"},
        {"until = -2", "a.toml:12:9: until = -2 and dt = 0.1 differ in sign"}};
    for (const auto& [keys, message] : cases)
        EXPECT_THAT(refusal_of_scene(run + keys + "\n"), HasSubstr(message)) << keys;
    const RunDescription there = describe(read_scene(run + "dt = 0.01\n[start]\nmode = 2\namplitude = 0.1\n"));
    RunDescription back = there;
    back.dt = -0.01;
    const RunDescription written = describe(read_scene(scene_file_text(back)));
    EXPECT_EQ(written.dt, -0.01);
    Simulation one(back), two(written);
    one.advance(20);
    two.advance(20);
    EXPECT_LT(one.time(), 0);
    EXPECT_EQ(one.state().displacement.at(3), two.state().displacement.at(3));
}

TEST(StartingValues, are_the_same_from_their_text) {
    StartingValues values{.given = "a", .positions = {{0.1, 1e-300, 3}}, .velocities = {{1.0 / 3, 0, -2}}};
    const auto again = [](const StartingValues& of) {
        return starting_values(TextInput("b", std::make_shared<const std::string>(csv_text(of))), {});
    };
    EXPECT_EQ(again(values), values);
    values.displacements = {{1e-17, 2, 3}};
    EXPECT_EQ(again(values), values);
    EXPECT_EQ(file_at_step("a:b.csv:12").step, 12u);
    EXPECT_EQ(file_at_step("a:b.csv").file, "a:b.csv");
    EXPECT_FALSE(file_at_step("a.csv:").step);
}

TEST(StartingValues, need_all_particles) {
    const auto text = std::make_shared<const std::string>("step,time,particle,x,y,z\n0,0,0,1,2,3\n0,0,2,1,2,3\n");
    EXPECT_THROW(starting_values(TextInput("b", text), {}), FileError);
}

}  // namespace
}  // namespace steplab::test
