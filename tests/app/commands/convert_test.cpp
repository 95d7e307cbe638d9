#include "app/program.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::Not;

class Convert : public testing::Test {
protected:
    /// The run's rows in a file of this ending.
    std::string run_to(const std::string& ending) {
        const std::string file = folder_.file("run." + ending);
        const Outcome outcome = run_program({"run", "--model", "rope", "--steps", "40", "--every", "1", "--precision",
                                             "float", "--particles", "1-4,9", "--out", file});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return file;
    }
    TemporaryFolder folder_;
};

TEST_F(Convert, gives_the_bytes_that_the_run_itself_writes) {
    const std::string trajectory = run_to("trajectory");
    for (const std::string ending : {"csv", "xyz", "trajectory"}) {
        const std::string direct = text_of(run_to(ending));
        const std::string file = folder_.file("converted." + ending);
        const Outcome outcome = run_program({"convert", trajectory, "--out", file});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(text_of(file), direct);
        EXPECT_EQ(run_program({"convert", trajectory, "--format", ending}).out, direct);
    }
}

TEST_F(Convert, writes_the_frames_of_a_truncated_file_and_reports_it) {
    const std::string whole = text_of(run_to("trajectory"));
    const std::string cut = folder_.file("cut.trajectory");
    put_text(cut, whole.substr(0, whole.size() - 20));
    const std::string file = folder_.file("cut.csv");
    const Outcome outcome = run_program({"convert", cut, "--out", file});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("truncated or damaged after its first 41 frames"));
    EXPECT_EQ(text_of(file), text_of(run_to("csv")));
}

TEST_F(Convert, of_a_trajectory_with_a_damaged_chunk_writes_the_frames_before_it) {
    const std::string whole = folder_.file("whole.trajectory"), damaged = folder_.file("damaged.trajectory");
    ASSERT_EQ(
        run_program({"run", "--model", "chain", "--set", "n=1000", "--steps", "200", "--every", "2", "--out", whole})
            .code,
        0);
    std::string bytes = text_of(whole);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    put_text(damaged, bytes);
    for (const std::string to : {"csv", "xyz", "dump", "trajectory"}) {
        SCOPED_TRACE(to);
        const std::string all = folder_.file("all." + to), part = folder_.file("part." + to);
        ASSERT_EQ(run_program({"convert", whole, "--out", all}).code, 0);
        const Outcome outcome = run_program({"convert", damaged, "--out", part});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr(" frames before it were written"));
        const std::string written = text_of(part);
        EXPECT_GT(written.size(), text_of(all).size() / 3);
        if (to != "trajectory") {
            EXPECT_EQ(written, text_of(all).substr(0, written.size()));
        }
    }
}

TEST_F(Convert, takes_the_options_of_a_scene_only_where_they_say_something) {
    const std::string trajectory = folder_.file("a.trajectory"), text = folder_.file("a.csv");
    for (const std::string& out : {trajectory, text})
        ASSERT_EQ(run_program({"run", "--model", "chain", "--steps", "5", "--every", "1", "--out", out}).code, 0);
    const auto message = [&](const std::vector<std::string>& words) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 2);
        return outcome.err;
    };
    const std::string out = folder_.file("b.trajectory");
    EXPECT_THAT(message({"convert", trajectory, "--model", "mesh", "--out", out}), HasSubstr("leave them out"));
    EXPECT_THAT(message({"convert", text, "--model", "chain", "--out", folder_.file("b.xyz")}),
                HasSubstr("leave them out"));
    EXPECT_THAT(message({"convert", text, "--model", "chain", "--out", folder_.file("b.dump")}),
                HasSubstr("leave them out"));
    EXPECT_THAT(message({"convert", text, "--model", "chain", "--dt", "0.2", "--out", out}),
                HasSubstr("is it another dt?"));
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Convert, of_a_text_whose_scene_is_named_gives_the_trajectory_of_its_run) {
    const std::string trajectory = folder_.file("run.trajectory"), rows = folder_.file("run.csv");
    for (const std::string& out : {trajectory, rows})
        ASSERT_EQ(run_program({"run", "--model", "rope", "--steps", "20", "--every", "2", "--out", out}).code, 0);
    for (const std::string by : {"csv", "xyz", "dump", "xyz.zst"}) {
        SCOPED_TRACE(by);
        const std::string text = folder_.file("way." + by), back = folder_.file("back.trajectory");
        ASSERT_EQ(run_program({"convert", trajectory, "--out", text}).code, 0);
        std::vector<std::string> named{"convert", text, "--out", back};
        const Outcome refused = run_program(named);
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.err, HasSubstr("name its scene (--model or --scene"));
        named.insert(named.end(), {"--model", "rope"});
        ASSERT_EQ(run_program(named).code, 0);
        ASSERT_EQ(run_program({"convert", back, "--out", folder_.file("back.csv")}).code, 0);
        EXPECT_EQ(text_of(folder_.file("back.csv")), text_of(rows));
        named.insert(named.end(), {"--set", "n=31"});
        const Outcome other = run_program(named);
        EXPECT_EQ(other.code, 2);
        EXPECT_THAT(other.err, HasSubstr("is it another scene?"));
    }
}

TEST_F(Convert, of_a_text_whose_scene_begins_elsewhere_is_refused) {
    const std::string rows = folder_.file("run.csv"), back = folder_.file("back.trajectory");
    ASSERT_EQ(run_program({"run", "--model", "chain", "--steps", "4", "--every", "2", "--out", rows}).code, 0);
    for (const auto& [setting, what] : {std::pair("L=2.01", "position of particle 1 "), {"v0=2.01", "velocity of"}}) {
        const Outcome other = run_program(
            {"convert", rows, "--model", "chain", "--set", setting, "--out", back, "--format", "trajectory"});
        EXPECT_EQ(other.code, 2);
        EXPECT_THAT(other.err, HasSubstr("is not the start of the scene, where the "));
        EXPECT_THAT(other.err, HasSubstr(what));
        EXPECT_FALSE(std::filesystem::exists(back));
    }
    EXPECT_EQ(
        run_program({"convert", rows, "--model", "chain", "--set", "L=2.01", "--from", rows + ":0", "--out", back})
            .code,
        0)
        << "another start was named";
}

TEST_F(Convert, of_a_text_to_a_trajectory_says_what_is_left_out) {
    const std::string dump = folder_.file("a.dump");
    put_text(dump,
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ss ss ss\n0 1\n0 1\n0 1\n"
             "ITEM: ATOMS id type x y z vx vy vz c_pe\n1 1 0 0 0 0 0 0 -3\n");
    put_text(folder_.file("one.toml"), "steplab = 1\n[[particles]]\n");
    const Outcome made =
        run_program({"convert", dump, "--scene", folder_.file("one.toml"), "--out", folder_.file("a.trajectory")});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_THAT(made.err, HasSubstr("note: trajectory files have no columns for what is left out: type, c_pe"));
}

TEST_F(Convert, of_a_dump_of_an_export_to_vtk_has_its_springs) {
    const Surroundings here{.folder = folder_.path()};
    ASSERT_EQ(run_program({"export", "--model", "chain", "--steps", "4", "--to", "lammps", "--out", "job"}, here).code,
              0);
    ASSERT_EQ(run_program({"run", "--model", "chain", "--steps", "4", "--out", "rows.xyz"}, here).code, 0);
    ASSERT_EQ(run_program({"convert", "rows.xyz", "--out", "job/trajectory.dump", "--format", "dump"}, here).code, 0);
    ASSERT_EQ(run_program({"convert", "job/trajectory.dump", "--out", "job/frames.pvd"}, here).code, 0);
    EXPECT_THAT(text_of(folder_.file("job/frames/000000.vtp")), HasSubstr("NumberOfLines=\"9\"")) << "of ten particles";
    std::filesystem::rename(folder_.file("job/trajectory.dump"), folder_.file("job/other.dump"));
    ASSERT_EQ(run_program({"convert", "job/other.dump", "--out", "job/none.pvd"}, here).code, 0);
    EXPECT_THAT(text_of(folder_.file("job/none/000000.vtp")), Not(HasSubstr("NumberOfLines")));
}

// Texts of other programs too: what was whole before the fault is not lost.
TEST_F(Convert, writes_the_frames_of_a_text_before_its_fault_and_reports_it) {
    const std::string trajectory = run_to("trajectory");
    for (const std::string from : {"csv", "xyz", "dump", "xyz.gz"}) {
        const std::string text = folder_.file("whole." + from), cut = folder_.file("cut." + from);
        ASSERT_EQ(run_program({"convert", trajectory, "--out", text}).code, 0);
        const std::string whole = text_of(text);
        put_text(cut, whole.substr(0, whole.size() * 2 / 3));
        for (const std::string to : {"csv", "xyz", "dump", "pvd"}) {
            SCOPED_TRACE(from + " to " + to);
            const std::string all = folder_.file(from + ".all." + to), part = folder_.file(from + ".part." + to);
            ASSERT_EQ(run_program({"convert", text, "--out", all}).code, 0);
            const Outcome outcome = run_program({"convert", cut, "--out", part});
            EXPECT_EQ(outcome.code, 3);
            EXPECT_THAT(outcome.err, HasSubstr(" frames before it were written"));
            const std::string written = text_of(part);
            EXPECT_GT(written.size(), text_of(all).size() / 3);
            if (to != "pvd") {
                EXPECT_EQ(written, text_of(all).substr(0, written.size()));
            }
        }
    }
}

TEST_F(Convert, of_a_text_without_a_whole_frame_leaves_what_was_there) {
    const std::string out = folder_.file("kept.csv");
    put_text(folder_.file("cut.xyz"), "5\n\nA 1 2 3\n");
    put_text(out, "before");
    EXPECT_EQ(run_program({"convert", folder_.file("cut.xyz"), "--out", out}).code, 3);
    EXPECT_EQ(text_of(out), "before");
}

TEST_F(Convert, of_no_whole_frame_leaves_what_was_there) {
    const std::string whole = text_of(run_to("trajectory"));
    const std::string cut = folder_.file("cut.trajectory"), out = folder_.file("kept.trajectory");
    put_text(cut, whole.substr(0, whole.size() / 2));
    put_text(out, "before");
    const Outcome outcome = run_program({"convert", cut, "--out", out});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("holds no whole frame"));
    EXPECT_EQ(text_of(out), "before");
}

TEST_F(Convert, refuses_what_it_cannot_read_or_write) {
    const std::string trajectory = run_to("trajectory");
    std::string damaged = text_of(trajectory);
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    put_text(folder_.file("damaged.trajectory"), damaged);
    const std::string out = folder_.file("out.csv");
    put_text(folder_.file("a.txt"), "hello\n");
    for (const std::string& file :
         {folder_.file("damaged.trajectory"), folder_.file("missing"), folder_.file("a.txt")}) {
        const Outcome outcome = run_program({"convert", file, "--out", out});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("cannot read '" + file + "'"));
        EXPECT_FALSE(std::filesystem::exists(out));
    }
    EXPECT_EQ(run_program({"convert", trajectory}, {.standard_output = "/dev/full"}).code, 3);
    EXPECT_EQ(run_program({"convert", trajectory, "--out", "/dev/full"}).code, 3);
    EXPECT_EQ(run_program({"convert"}).code, 2);
    EXPECT_EQ(run_program({"convert", trajectory, "--out", folder_.file("out.txt")}).code, 2);
}

TEST_F(Convert, full_disk_leaves_no_trajectory_behind) {
    const std::string file = folder_.file("large.trajectory");
    const Outcome outcome = run_program(
        {"run", "--model", "morse", "--set", "edge=8", "--every", "1", "--steps", "99", "--dt", "0.01", "--out", file},
        {.largest_file = 100000});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("cannot write '" + file + "'"));
    EXPECT_TRUE(folder_.empty());
}

TEST_F(Convert, interrupted_run_keeps_a_trajectory_that_is_whole) {
    const std::string file = folder_.file("a.trajectory");
    RunningProgram run(
        {"run", "--model", "chain", "--steps", "1e14", "--every", "1", "--out", file, "--series", "/dev/stdout"});
    for (std::size_t read = 0; read < 1000000;) read += run.read_some().size();
    run.send(SIGINT);
    EXPECT_EQ(run.wait().code, 128 + SIGINT);
    const Outcome outcome = run_program({"convert", file + ".partial", "--out", folder_.file("a.csv")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(text_of(folder_.file("a.csv")), HasSubstr("\n1000,100,0,"));
}

}  // namespace
}  // namespace steplab
