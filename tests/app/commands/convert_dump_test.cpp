// What dumps of other programs have and steplab's own files have not: other columns in later frames, other units.
#include "app/program.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class ConvertDump : public testing::Test {
protected:
    /// A frame of two atoms with these columns, each number of which is 1.
    static std::string frame(int step, const std::string& columns, const std::string& row) {
        return "ITEM: TIMESTEP\n" + std::to_string(step) +
               "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\nITEM: ATOMS id " + columns +
               "\n1 " + row + "\n2 " + row + "\n";
    }
    std::string file_of(const std::string& text) {
        const std::string file = folder_.file("a.dump");
        put_text(file, text);
        return file;
    }
    Outcome convert_to(const std::string& ending, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"convert", folder_.file("a.dump"), "--out", folder_.file("out." + ending)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    std::string out(const std::string& ending) { return text_of(folder_.file("out." + ending)); }
    TemporaryFolder folder_;
};

// A file that names its columns once would lose some of them, or have zeros where there is nothing.
TEST_F(ConvertDump, whose_columns_change_is_written_up_to_there) {
    const std::string still = frame(0, "x y z", "1 1 1"), moving = frame(1, "x y z vx vy vz", "1 1 1 2 2 2"),
                      charged = frame(1, "x y z q", "1 1 1 7");
    for (const std::string& text : {still + moving, moving + still, still + charged, charged + still}) {
        file_of(text);
        for (const std::string to : {"csv", "xyz"}) {
            SCOPED_TRACE(to + " of\n" + text);
            const Outcome outcome = convert_to(to);
            EXPECT_EQ(outcome.code, 3);
            EXPECT_THAT(outcome.err, HasSubstr("a.dump', frame 1: its columns are x,y,z"));
            EXPECT_THAT(outcome.err, EndsWith("keeps what each has; the frame before it was written\n"));
            const Outcome once_more = run_program({"convert", folder_.file("out." + to), "--format", "dump"});
            EXPECT_EQ(once_more.code, 0) << once_more.err;
        }
    }
}

TEST_F(ConvertDump, whose_columns_change_keeps_them_where_each_frame_names_its_own) {
    file_of(frame(0, "x y z", "1 1 1") + frame(1, "x y z vx vy vz", "1 1 1 2 2 2") + frame(2, "x y z", "1 1 1"));
    EXPECT_EQ(convert_to("dump").code, 0);
    const std::string written = out("dump");
    const auto count = [&](const std::string& head) {
        std::size_t found = 0;
        for (std::size_t at = written.find(head); at != std::string::npos; at = written.find(head, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("ITEM: ATOMS id type x y z\n"), 2u) << written;
    EXPECT_EQ(count("ITEM: ATOMS id type x y z vx vy vz\n"), 1u) << written;
    EXPECT_EQ(convert_to("pvd").code, 0);
}

TEST_F(ConvertDump, whose_columns_change_gives_those_that_all_frames_have) {
    file_of(frame(0, "x y z q", "1 1 1 7") + frame(1, "x y z vx vy vz", "1 1 1 2 2 2"));
    EXPECT_EQ(convert_to("csv", {"--columns", "x,y,z"}).code, 0);
    EXPECT_THAT(out("csv"), EndsWith("1,1,1,1,1,1\n"));
    EXPECT_EQ(convert_to("csv", {"--columns", "x,y,z,vx"}).code, 3) << "the first frame has none";
}

TEST_F(ConvertDump, whose_velocities_end_makes_no_trajectory_of_particles_at_rest) {
    const std::string moving = "x y z vx vy vz", row = "1 1 1 2 2 2";
    file_of(frame(1, moving, row) + frame(2, moving, row) + frame(3, "x y z", "1 1 1"));
    const Outcome outcome = convert_to("trajectory", {"--model", "chain", "--set", "n=2"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("frame 2: its columns are x,y,z,"));
    EXPECT_THAT(outcome.err, HasSubstr("the 2 frames before it were written"));
}

TEST_F(ConvertDump, of_other_units_says_so_and_keeps_their_name_in_a_dump) {
    const std::string rows = frame(0, "x y z", "1 1 1") + frame(1, "x y z", "1 1 1");
    file_of("ITEM: UNITS\nmetal\n" + rows);
    for (const std::string to : {"csv", "xyz", "pvd"}) {
        const Outcome outcome = convert_to(to);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_THAT(outcome.err, HasSubstr("are in LAMMPS' units metal and stay as they are")) << to;
    }
    EXPECT_EQ(convert_to("dump").err, "");
    EXPECT_THAT(out("dump"), HasSubstr("ITEM: UNITS\nmetal\n"));
    file_of("ITEM: UNITS\nlj\n" + rows);
    EXPECT_EQ(convert_to("csv").err, "") << "steplab's own";
    file_of(rows);
    EXPECT_EQ(convert_to("csv").err, "") << "not said";
    EXPECT_EQ(convert_to("dump").code, 0);
    EXPECT_THAT(out("dump"), Not(HasSubstr("UNITS")));
}

}  // namespace
}  // namespace steplab
