#include "core/error.hpp"
#include "io/trajectories.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace steplab {
namespace {

using testing::HasSubstr;

/// The result of reading a file: the number of frames that the reader reports, or the message of its error.
struct Reading {
    bool complete = false;
    std::vector<Frame> frames;
    std::string refusal;
};

Reading reading_of(const std::string& file) {
    Reading reading;
    try {
        TrajectoryReader reader((InputFile(file)));
        reading.complete = reader.complete();
        reading.frames = read_all(reader);
    } catch (const FileError& error) {
        reading.refusal = error.what();
    }
    return reading;
}

/// A file of three frames in a chunk each, and its bytes.
class SmallFile : public testing::Test {
protected:
    void SetUp() override {
        {
            OutputFile file(name_);
            TrajectoryWriter writer(file, TrajectoryFormat::trajectory, describe("chain"), {});
            for (const Frame& frame : frames_) {
                writer.add(frame);
                writer.flush();
            }
            writer.finish();
            file.commit();
        }
        bytes_ = text_of(name_);
    }
    Reading reading_of_bytes(std::string_view bytes) const {
        std::filesystem::remove(name_);  // some file systems wait for the disk where a file is cut and written again
        put_text(name_, bytes);
        return reading_of(name_);
    }

    TemporaryFolder folder_;
    std::string name_ = folder_.file("a.trajectory");
    std::vector<Frame> frames_ = frames_of(describe("chain"), 3);
    std::string bytes_;
};

TEST_F(SmallFile, cut_anywhere_gives_the_frames_before_or_is_refused) {
    std::size_t most = 0;
    for (std::size_t length = 0; length < bytes_.size(); ++length) {
        const Reading reading = reading_of_bytes(std::string_view(bytes_).substr(0, length));
        const auto count = static_cast<std::ptrdiff_t>(reading.frames.size());
        ASSERT_LE(count, 3);
        ASSERT_TRUE(same_frames(reading.frames, {frames_.begin(), frames_.begin() + count})) << length;
        ASSERT_GE(reading.frames.size(), most) << length;
        ASSERT_TRUE(reading.refusal.empty() || most == 0) << length;  // once there is a frame all cuts can be read
        most = std::max(most, reading.frames.size());
    }
    EXPECT_EQ(most, 3u);
    EXPECT_TRUE(reading_of_bytes(bytes_).complete);
    EXPECT_FALSE(reading_of_bytes(std::string_view(bytes_).substr(0, bytes_.size() * 3 / 4)).complete);
}

TEST_F(SmallFile, changed_anywhere_gives_right_frames_or_is_refused) {
    std::size_t refused = 0;
    for (std::size_t place = 0; place < bytes_.size(); ++place) {
        std::string changed = bytes_;
        changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
        const Reading reading = reading_of_bytes(changed);
        if (!reading.refusal.empty()) {
            ++refused;
            continue;
        }
        const auto count = static_cast<std::ptrdiff_t>(reading.frames.size());
        ASSERT_TRUE(same_frames(reading.frames, {frames_.begin(), frames_.begin() + count})) << place;
        ASSERT_TRUE(!reading.complete || count == 3) << place;
    }
    EXPECT_GT(refused, bytes_.size() / 2);
    EXPECT_LT(refused, bytes_.size());  // without its index a file is still read
}

/// The file with one block changed by `forge` and all hashes recomputed: no accident does that.
template <class Forge>
std::string forged(const std::string& bytes, std::size_t which, const Forge& forge) {
    using namespace trajectory;
    std::string made = bytes.substr(0, signature_bytes);
    std::size_t place = signature_bytes;
    std::uint64_t index_place = 0;
    for (std::size_t i = 0; place + ending_bytes < bytes.size(); ++i) {
        BlockHead head = parse_head(std::string_view(bytes).substr(place)).value();
        std::string content = bytes.substr(place + BlockHead::bytes, head.content_bytes);
        place += BlockHead::bytes + content.size();
        if (i == which) forge(head, content);
        index_place = made.size();
        made += head_bytes(head, content) + content;
    }
    return made + ending(index_place);
}

TEST_F(SmallFile, forged_with_right_hashes_is_read_or_refused) {
    constexpr std::size_t blocks = 5;  // description, three chunks, index
    ASSERT_EQ(forged(bytes_, blocks, [](auto&, auto&) {}), bytes_);
    std::size_t tried = 0, refused = 0;
    const auto try_to_read = [&](std::size_t block, const auto& forge) {
        ++tried;
        refused += reading_of_bytes(forged(bytes_, block, forge)).refusal.empty() ? 0 : 1;
    };
    for (std::size_t block = 0; block < blocks; ++block) {
        for (const std::uint64_t value : {0ull, 1ull, 2ull, 1ull << 20, 1ull << 32, 1ull << 63, ~0ull}) {
            using trajectory::BlockHead;
            for (const auto field : {&BlockHead::first_frame, &BlockHead::first_row, &BlockHead::rows}) {
                if (block == blocks - 1 && value > 2)
                    continue;  // the number of frames is read before they are found missing
                try_to_read(block, [&](BlockHead& head, std::string&) { head.*field = value; });
            }
            try_to_read(block, [&](BlockHead& head, std::string&) { head.frames = static_cast<std::uint32_t>(value); });
        }
        const std::size_t length = block == 0 ? 600 : 150;
        for (std::size_t place = 0; place < length; ++place) {
            try_to_read(block, [&](auto&, std::string& content) {
                if (place < content.size()) content[place] = static_cast<char>(content[place] ^ (1 << place % 7));
            });
        }
    }
    EXPECT_GT(refused, tried / 5);  // not a chunk, not JSON, not a place in the file
    EXPECT_LT(refused, tried);      // another parameter or digit is as valid as the true one
}

TEST_F(SmallFile, that_is_none_is_refused_with_the_reason) {
    std::string newer = bytes_;
    newer[12] = 3;
    EXPECT_THAT(reading_of_bytes("").refusal, HasSubstr("it is not a trajectory"));
    EXPECT_THAT(reading_of_bytes("step,time,particle\n").refusal, HasSubstr("it is not a trajectory"));
    EXPECT_THAT(reading_of_bytes(newer).refusal, HasSubstr("version"));
    EXPECT_THAT(reading_of_bytes(bytes_.substr(0, 20)).refusal, HasSubstr("damaged at its beginning"));
    for (const std::string& name : {std::string("/dev/null"), folder_.path(), folder_.file("missing")})
        EXPECT_THAT(reading_of(name).refusal, HasSubstr("cannot read '" + name + "'"));
}

/// The file with another description.
std::string described(const std::string& bytes, const std::string& description) {
    return forged(bytes, 0, [&](auto&, std::string& content) { content = description; });
}

TEST_F(SmallFile, that_nests_brackets_is_refused_whatever_their_depth) {
    for (const std::size_t depth : {20u, 1000u, 50000u, 1000000u}) {
        for (const std::string& run : {std::string(depth, '['), std::string(depth, '[') + std::string(depth, ']')}) {
            const Reading reading = reading_of_bytes(described(bytes_, "{\"program\":\"\",\"run\":" + run + "}"));
            EXPECT_THAT(reading.refusal, HasSubstr("the description of its run is not valid")) << depth;
        }
    }
}

TEST_F(SmallFile, whose_run_has_an_unknown_parameter_has_no_run) {
    const auto run_of = [&](const std::string& name) {
        std::string text = bytes_.substr(trajectory::signature_bytes + trajectory::BlockHead::bytes);
        text.resize(text.find('\n') + 1);
        text.replace(text.find("\"m\":"), 4, "\"" + name + "\":");
        const Kept file(described(bytes_, text));
        return TrajectoryReader(InputFile(file.name())).run();
    };
    EXPECT_EQ(run_of("m"), describe("chain"));
    EXPECT_THAT([&] { run_of("q"); }, testing::ThrowsMessage<FileError>(HasSubstr("unknown parameter 'q'")));
}

/// The same description, of the same length, with other rows: `rows` of them, all moving.
std::string with_rows(const std::string& bytes, const std::string& rows) {
    const auto head = trajectory::parse_head(std::string_view(bytes).substr(trajectory::signature_bytes)).value();
    std::string text = bytes.substr(trajectory::signature_bytes + trajectory::BlockHead::bytes, head.content_bytes);
    const auto replace = [&text](std::string_view from, std::string_view to, const std::string& with) {
        const std::size_t begin = text.find(from);
        text.replace(begin, text.find(to, begin) - begin, with);
    };
    replace(",\"command_line\"", "}", "");
    replace("\"rows\":", ",\"mass\"",
            "\"rows\":" + rows + ",\"particles\":[[0," + rows + "]],\"roles\":[[\"moving\"," + rows + "]]");
    text.resize(std::max<std::size_t>(text.size(), head.content_bytes), ' ');
    return described(bytes, text);
}

TEST_F(SmallFile, that_claims_many_rows_is_refused_without_making_them) {
    EXPECT_TRUE(reading_of_bytes(with_rows(bytes_, "10")).refusal.empty());
    for (const std::string rows : {"11", "300000000", "1000000000000000", "18446744073709551615"})
        EXPECT_THAT(reading_of_bytes(with_rows(bytes_, rows)).refusal, HasSubstr("not complete")) << rows;
    for (const std::string rows : {"0", "9", "-1", "1.5", "18446744073709551616"})
        EXPECT_FALSE(reading_of_bytes(with_rows(bytes_, rows)).refusal.empty()) << rows;
}

TEST_F(SmallFile, with_a_hole_behind_it_is_read_up_to_there) {
    for (const std::uintmax_t size : {std::uintmax_t{1} << 30, std::uintmax_t{1} << 40}) {
        for (const std::size_t kept : {bytes_.size(), bytes_.size() - 40, std::size_t{100}}) {
            reading_of_bytes(std::string_view(bytes_).substr(0, kept));
            std::filesystem::resize_file(name_, size);
            const Reading reading = reading_of(name_);
            EXPECT_EQ(reading.complete, kept == bytes_.size());  // the index is found without its place at the end
            EXPECT_EQ(reading.frames.size(), kept > 100 ? 3u : 0u);
        }
    }
}

/// A block whose content is said to fill the rest of a file that holds nothing.
TEST_F(SmallFile, whose_blocks_claim_a_hole_is_refused) {
    using namespace trajectory;
    for (const BlockKind kind : {BlockKind::description, BlockKind::frames, BlockKind::index}) {
        const std::uint64_t index = parse_ending(bytes_.substr(bytes_.size() - ending_bytes)).value();
        const std::string bytes = bytes_.substr(0, kind == BlockKind::description ? signature_bytes : index);
        std::string head = head_bytes({.kind = kind, .frames = 1, .first_frame = 3, .rows = 10}, "");
        const std::uint64_t claimed = std::uint64_t{1} << 39;
        for (std::size_t i = 0; i < 8; ++i) head[32 + i] = static_cast<char>(claimed >> (8 * i) & 0xff);
        const std::uint64_t hash = hash_of(head.substr(0, 48));
        for (std::size_t i = 0; i < 8; ++i) head[48 + i] = static_cast<char>(hash >> (8 * i) & 0xff);
        reading_of_bytes(bytes + head);
        std::filesystem::resize_file(name_, std::uintmax_t{1} << 40);
        const Reading reading = reading_of(name_);
        EXPECT_FALSE(reading.complete);
        EXPECT_EQ(reading.frames.size(), kind == BlockKind::description ? 0u : 3u);
    }
}

}  // namespace
}  // namespace steplab
