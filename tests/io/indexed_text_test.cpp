// The frames of texts in any order, found once, also while another program writes them.

#include "io/indexed_text.hpp"

#include "core/error.hpp"
#include "io/compression.hpp"
#include "io/files.hpp"
#include "io/text_trajectory.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// Frames of two particles in each format. A frame of CSV or XYZ ends like the next one begins: not at all.
std::string dump_of(int frames) {
    std::string text;
    for (int i = 0; i < frames; ++i)
        text += fmt::format(
            "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n-1 3\n0 2\n10 20\n"
            "ITEM: ATOMS id type x y z\n2 2 1 1 {}\n1 1 0 0 11\n",
            10 * i, 12 + i);
    return text;
}
std::string xyz_of(int frames) {
    std::string text;
    for (int i = 0; i < frames; ++i)
        text += fmt::format("2\nTime={} Step={} Properties=species:S:1:pos:R:3:q:R:1\nH 0 0 11 1\nO 1 1 {} {}\n",
                            0.5 * i, 10 * i, 12 + i, i);
    return text;
}
std::string csv_of(int frames) {
    std::string text = "step,time,particle,x,y,z\n";
    for (int i = 0; i < frames; ++i)
        text += fmt::format("{0},{1},0,0,0,11\n{0},{1},1,1,1,{2}\n", 10 * i, 0.5 * i, 12 + i);
    return text;
}

std::vector<FrameBlock> read_whole(const std::string& file) {
    std::vector<FrameBlock> frames;
    const auto text = TextTrajectory::open(TextInput(InputFile(file)), TextTrajectory::From::any_program);
    for (FrameBlock frame; text->next(frame);) frames.push_back(frame);
    return frames;
}

class IndexedFile : public testing::Test {
protected:
    std::string written(const std::string& name, const std::string& text) const {
        put_text(folder_.file(name), text);
        return folder_.file(name);
    }
    std::string compressed(const std::string& name, const std::string& text) const {
        std::string bytes;
        const auto to = compressor(compression_of(name));
        to->add(text, bytes);
        to->finish(bytes);
        return written(name, bytes);
    }
    static void look_through(IndexedText& frames, std::uint64_t bytes = 100) {
        while (frames.has_more()) frames.look_on(bytes);
    }
    static std::string fault_of(const std::string& file) {
        try {
            IndexedText frames(file);
            look_through(frames);
            return frames.fault();
        } catch (const FileError& error) {
            return error.what();
        }
    }

private:
    TemporaryFolder folder_;
};

// The reader from front to back is the measure, for every format and any number of lines.
TEST_F(IndexedFile, has_the_frames_that_are_read_from_front_to_back) {
    std::mt19937 random(5);
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"a.dump", dump_of(40)},
             {"a.xyz", xyz_of(40)},
             {"a.csv", csv_of(40)},
             {"one.csv", csv_of(1)},
             {"open.csv", csv_of(3).substr(0, csv_of(3).size() - 1)},
             {"open.xyz", xyz_of(3).substr(0, xyz_of(3).size() - 1)},
             {"blank.xyz", xyz_of(2) + "\n\n"},
             {"single.csv", "step,time,particle,x,y,z\n0,0,4,1,2,3\n1,0.5,4,2,2,3\n2,1,4,3,2,3\n"},
             {"again.csv", "step,time,particle,x,y,z\n0,0,1,1,2,3\n0,0,2,2,2,3\n0,0,1,3,2,3\n0,0,2,4,2,3\n"},
             {"plain.xyz", "1\nany words\nH 1 2 3\n1\n\nH 2 3 4\n"},
             {"r.csv", "step,time,particle,x,y,z\r\n0,0,0,1,2,3\r\n5,1,0,2,2,3\r\n"}}) {
        SCOPED_TRACE(name);
        const std::string file = written(name, text);
        const std::vector<FrameBlock> whole = read_whole(file);
        IndexedText frames(file);
        look_through(frames, 1 + random() % 200);
        ASSERT_EQ(frames.frames(), whole.size());
        EXPECT_EQ(frames.fault(), "");
        EXPECT_EQ(frames.looked_through(), 1);
        std::vector<std::uint64_t> order(whole.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), random);
        Frame frame;
        for (const std::uint64_t number : order) {
            frames.frame(number, frame);
            EXPECT_EQ(frame.positions, whole[number].positions);
            EXPECT_EQ(frame.step, whole[number].moments.front().step);
            EXPECT_EQ(frames.moment(number).step, frame.step);
            EXPECT_EQ(frame.values ? frame.values->size() : 0, whole[number].values.size());
        }
    }
}

TEST_F(IndexedFile, has_types_as_groups_and_further_numbers) {
    Frame frame;
    IndexedText(written("a.dump", dump_of(1))).frame(0, frame);
    EXPECT_EQ(frame.shape->groups, (std::vector<std::uint16_t>{0, 1}));
    EXPECT_EQ(frame.values, nullptr);
    IndexedText(written("a.xyz", xyz_of(3))).frame(1, frame);
    ASSERT_NE(frame.values, nullptr);
    EXPECT_EQ(*frame.values, (std::vector<ParticleValues>{{"q", {1, 1}}}));
}

TEST_F(IndexedFile, without_times_has_a_second_for_each_step) {
    IndexedText frames(written("a.xyz", "1\nStep=100\nH 1 2 3\n1\nStep=250\nH 2 3 4\n"));
    EXPECT_EQ(frames.moment(0).time, 100) << "both are known from the first moment on";
    EXPECT_EQ(frames.moment(1).time, 250);
    EXPECT_EQ(IndexedText(written("b.xyz", xyz_of(2))).moment(1).time, 0.5);
}

TEST_F(IndexedFile, is_read_compressed_piece_by_piece) {
    for (const char* const ending : {".gz", ".zst"}) {
        for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
                 {"a.dump", dump_of(30000)}, {"a.xyz", xyz_of(30000)}, {"a.csv", csv_of(60000)}}) {
            SCOPED_TRACE(name + ending);
            IndexedText frames(compressed(name + ending, text));
            EXPECT_TRUE(frames.has_more()) << "its first frames are there before its last ones are restored";
            EXPECT_LT(frames.frames(), name == "a.csv" ? 60000u : 30000u);
            EXPECT_LE(frames.looked_through(), 1);
            look_through(frames, 100000);
            EXPECT_EQ(frames.frames(), name == "a.csv" ? 60000u : 30000u);
            EXPECT_EQ(frames.fault(), "");
            Frame frame;
            frames.frame(29999, frame);
            EXPECT_EQ(frame.positions[1].z, 12 + 29999);
        }
    }
}

TEST_F(IndexedFile, that_ends_within_its_compressed_data_is_shown_up_to_there) {
    std::string text = "step,time,particle,x,y,z\n";
    std::mt19937 random(7);  // what cannot be compressed well, so that a piece of it is cut off
    for (int i = 0; i < 100000; ++i) text += fmt::format("{},{},0,{},{},{}\n", i, i, random(), random(), random());
    const std::string file = compressed("a.csv.gz", text);
    const std::string bytes = text_of(file);
    written("a.csv.gz", bytes.substr(0, bytes.size() * 3 / 4));
    IndexedText frames(file);
    look_through(frames);
    EXPECT_GT(frames.frames(), 10000u);
    EXPECT_LT(frames.frames(), 100000u);
    EXPECT_THAT(frames.fault(), HasSubstr("its compressed data is truncated"));
    Frame frame;
    EXPECT_NO_THROW(frames.frame(frames.frames() - 1, frame));
}

// Another program is writing it: a frame is there once its last line is. What is there when it is opened is taken as
// it stands, since a text that is complete may lack the end of its last line.
TEST_F(IndexedFile, is_followed_while_it_grows) {
    for (const auto& [name, of] : std::vector<std::pair<std::string, std::string (*)(int)>>{
             {"a.dump", dump_of}, {"a.xyz", xyz_of}, {"a.csv", csv_of}}) {
        SCOPED_TRACE(name);
        const std::string text = of(4);
        IndexedText frames(written(name, of(2)));
        ASSERT_EQ(frames.frames(), 2u);
        for (std::size_t bytes = of(2).size(); bytes <= text.size(); ++bytes) {
            written(name, text.substr(0, bytes));
            frames.look_on(1000);
            const int whole = bytes == text.size() ? 4 : bytes >= of(3).size() ? 3 : 2;
            ASSERT_EQ(frames.frames(), static_cast<std::uint64_t>(whole)) << bytes;
            const bool at_end = bytes == of(whole).size();
            ASSERT_EQ(frames.fault().empty(), at_end) << bytes;
        }
        Frame frame;
        frames.frame(3, frame);
        EXPECT_EQ(frame.positions[1].z, 15);
    }
}

TEST_F(IndexedFile, reads_a_line_again_that_was_not_written_to_its_end) {
    for (const auto& [name, of] :
         std::vector<std::pair<std::string, std::string (*)(int)>>{{"a.xyz", xyz_of}, {"a.csv", csv_of}}) {
        SCOPED_TRACE(name);
        const std::string text = of(3);
        IndexedText frames(written(name, of(2).substr(0, of(2).size() - 3)));
        ASSERT_EQ(frames.frames(), 2u);
        written(name, text);
        frames.look_on(1000);
        EXPECT_EQ(frames.frames(), 3u);
        EXPECT_EQ(frames.fault(), "");
        Frame frame;
        frames.frame(1, frame);
        EXPECT_EQ(frame.positions[1].z, 13);
        frames.frame(2, frame);
        EXPECT_EQ(frame.positions[1].z, 14);
    }
}

TEST_F(IndexedFile, says_why_there_are_no_more_frames) {
    EXPECT_EQ(fault_of(written("good.dump", dump_of(3))), "");
    const auto faulty = [&](const std::string& name, const std::string& text, const std::string& why) {
        SCOPED_TRACE(why);
        IndexedText frames(written(name, text));
        look_through(frames);
        EXPECT_EQ(frames.frames(), 3u) << "those before";
        EXPECT_THAT(frames.fault(), HasSubstr(why));
    };
    const std::string head =
        "ITEM: TIMESTEP\n30\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
    const auto with = [&](const char* count) {
        return fmt::format(fmt::runtime(head), count) + "ITEM: ATOMS id x y z\n1 0 0 0\n";
    };
    faulty("a.dump", dump_of(3) + with("1") + dump_of(3), "line 34: frame 4 has 1 rows, the ones before 2");
    faulty("b.dump", dump_of(3) + dump_of(3),
           "line 34: the frame that begins here is of step 0, the one before of step 20");
    faulty("c.dump", dump_of(3) + with("2147483648"), "the file ends within a frame");
    faulty("d.dump", dump_of(3) + "hello\n", "line 34: a frame of a LAMMPS dump begins with ITEM: TIMESTEP");
    faulty("a.xyz", xyz_of(3) + "1\n\nH 0 0 0\n", "line 13: frame 4 has 1 rows, the ones before 2");
    faulty("b.xyz", xyz_of(3) + "H 0 0 0\n", "line 13: \"H\" is not a number");
    faulty("c.xyz", xyz_of(3) + "2\nStep=x\nH 0 0 0\n", "line 14: \"x\" is not a number");
    faulty("d.xyz", xyz_of(3) + "2147483648\n\nH 0 0 0\n", "the file ends within a frame");
    faulty("e.xyz", xyz_of(3) + "\n" + xyz_of(1), "a frame cannot follow an empty line");
    faulty("a.csv", csv_of(3) + "30,1.5,0,0,0,0\n", "the file ends within a frame");
    faulty("b.csv", csv_of(3) + "30,1.5,0,0,0,0\n40,2,0,0,0,0\n", "line 8: frame 4 has 1 rows, the ones before 2");
    faulty("c.csv", csv_of(3) + "20,1,7,0,0,0\n", "line 8: a frame has more rows than the 2 of the first one");
    faulty("d.csv", csv_of(3) + "30;1.5;0\n", "line 8: it does not begin with the numbers of a step");
}

TEST_F(IndexedFile, finds_damaged_rows_when_their_frame_is_read) {
    for (const auto& [name, text, from, to] :
         std::vector<std::array<std::string, 4>>{{"a.dump", dump_of(3), "2 2 1 1 13", "2 2 1 x 13"},
                                                 {"b.dump", dump_of(3), "2 2 1 1 13", "2 2 nan 1 13"},
                                                 {"a.xyz", xyz_of(3), "O 1 1 13", "O 1 x 13"},
                                                 {"a.csv", csv_of(3), "10,0.5,1,1,1", "10,0.5,1,1,x"}}) {
        SCOPED_TRACE(name);
        std::string damaged = text;
        damaged.replace(damaged.find(from), from.size(), to);
        IndexedText frames(written(name, damaged));
        look_through(frames);
        EXPECT_EQ(frames.frames(), 3u);
        Frame frame;
        EXPECT_NO_THROW(frames.frame(0, frame));
        EXPECT_NO_THROW(frames.frame(2, frame));
        try {
            frames.frame(1, frame);
            FAIL();
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), HasSubstr(name + "': line "));
            EXPECT_THAT(error.what(), HasSubstr("is not a number that can stand here"));
        }
    }
}

TEST_F(IndexedFile, that_has_no_frame_is_refused) {
    for (const char* const text : {"ITEM: TIMESTEP\n", "2\n\nH 0 0 0\n", "step,time,particle,x,y,z\n",
                                   "step,time,particle,speed\n0,0,0,1\n", "0\n\n", "what is this", ""})
        EXPECT_THROW(IndexedText(written("a", text)), FileError) << text;
    EXPECT_THAT(fault_of(written("long", "2\n" + std::string(200000, 'x'))), HasSubstr("line 2: it is too long"));
}

}  // namespace
}  // namespace steplab::test
