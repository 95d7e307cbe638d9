#include "io/trajectory.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/trajectory_reader.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <gmock/gmock.h>

#include <bit>

namespace steplab {
namespace {

using testing::HasSubstr;

const TrajectoryFormat all_formats[] = {TrajectoryFormat::csv, TrajectoryFormat::xyz, TrajectoryFormat::trajectory};

std::string written(const RunDescription& run, const std::vector<Frame>& frames, TrajectoryFormat format,
                    const std::vector<std::size_t>& particles = {}) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    TrajectoryWriter writer(file, format, run, particles);
    for (const Frame& frame : frames) writer.add(frame);
    writer.finish();
    file.commit();
    return text_of(folder.file("a"));
}

std::vector<Frame> frames_of(const RunDescription& run, std::size_t count) {
    Simulation simulation(run);
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < count; ++i) {
        frames.push_back(simulation.frame());
        simulation.advance(2);
    }
    return frames;
}

/// A trajectory in a file of its own.
class Kept {
public:
    explicit Kept(std::string_view bytes) { put_text(name(), bytes); }
    std::string name() const { return folder_.file("a.trajectory"); }

private:
    TemporaryFolder folder_;
};

std::vector<Frame> read_all(TrajectoryReader& reader) {
    std::vector<Frame> frames(reader.frames());
    for (std::size_t i = 0; i < frames.size(); ++i) reader.frame(i, frames[i]);
    return frames;
}

std::vector<std::uint64_t> bits_of(const Frame& frame) {
    std::vector<std::uint64_t> bits{frame.step, std::bit_cast<std::uint64_t>(frame.time)};
    for (const auto* vectors : {&frame.positions, &frame.velocities}) {
        for (const Vec3& v : *vectors) {
            for (const double value : {v.x, v.y, v.z}) bits.push_back(std::bit_cast<std::uint64_t>(value));
        }
    }
    return bits;
}

bool same_frames(const std::vector<Frame>& a, const std::vector<Frame>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Frame& left, const Frame& right) {
        return bits_of(left) == bits_of(right) && left.precision == right.precision;
    });
}

TEST(TrajectoryFile, gives_back_every_bit_of_every_model_in_both_precisions) {
    for (const Model& model : models()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            RunDescription run = describe(model.info.id);
            run.precision = precision;
            const std::vector<Frame> frames = frames_of(run, 5);
            const Kept file(written(run, frames, TrajectoryFormat::trajectory));
            TrajectoryReader reader(file.name());
            EXPECT_TRUE(reader.complete());
            EXPECT_EQ(reader.run(), run) << model.info.id;
            const std::vector<Frame> back = read_all(reader);
            EXPECT_TRUE(same_frames(back, frames)) << model.info.id;
            for (const TrajectoryFormat format : all_formats)
                EXPECT_EQ(written(run, back, format, reader.particles()), written(run, frames, format))
                    << model.info.id;
        }
    }
}

TEST(TrajectoryFile, holds_the_chosen_particles_by_their_numbers) {
    const RunDescription run = describe("chain");
    const std::vector<std::size_t> chosen{0, 1, 2, 7, 9};
    const std::vector<Frame> frames = frames_of(run, 3);
    const Kept file(written(run, frames, TrajectoryFormat::trajectory, chosen));
    TrajectoryReader reader(file.name());
    EXPECT_EQ(reader.particles(), chosen);
    const std::vector<Frame> back = read_all(reader);
    EXPECT_EQ(back[0].positions.size(), chosen.size());
    for (const TrajectoryFormat format : all_formats)
        EXPECT_EQ(written(run, back, format, reader.particles()), written(run, frames, format, chosen));
}

/// Frames of `particles` whose numbers identify frame and particle.
std::vector<Frame> counted_frames(std::size_t particles, std::size_t count) {
    Shape shape;
    shape.roles.assign(particles, Role::moving);
    Frame frame;
    frame.shape = std::make_shared<const Shape>(std::move(shape));
    std::vector<Frame> frames;
    for (std::size_t k = 0; k < count; ++k) {
        frame.step = k * 3;
        frame.time = 0.1 * static_cast<double>(k);
        frame.positions.clear();
        for (std::size_t i = 0; i < particles; ++i)
            frame.positions.push_back({static_cast<double>(k), static_cast<double>(i), -0.0});
        frame.velocities = frame.positions;
        frames.push_back(frame);
    }
    return frames;
}

TEST(TrajectoryFile, any_frame_is_found_whether_chunks_hold_many_or_pieces) {
    // 16384 rows are a chunk: many frames in one, just one, one and a row of the next, several chunks a frame.
    for (const std::size_t particles : {1000u, 16384u, 16385u, 40000u}) {
        const std::vector<Frame> frames = counted_frames(particles, 20);
        const Kept file(written(describe("chain"), frames, TrajectoryFormat::trajectory));
        TrajectoryReader reader(file.name());
        ASSERT_EQ(reader.frames(), frames.size());
        for (const std::size_t k : {19u, 0u, 7u, 16u, 15u, 17u}) {
            Frame frame;
            reader.frame(k, frame);
            EXPECT_EQ(bits_of(frame), bits_of(frames[k])) << particles << " particles, frame " << k;
        }
        Frame none;
        EXPECT_THROW(reader.frame(20, none), FileError);
    }
}

/// The result of reading a file: the number of frames that the reader reports, or the message of its error.
struct Reading {
    bool complete = false;
    std::vector<Frame> frames;
    std::string refusal;
};

Reading reading_of(const std::string& file) {
    Reading reading;
    try {
        TrajectoryReader reader(file);
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
    std::string made(signature);
    std::size_t place = signature.size();
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
    newer[12] = 2;
    EXPECT_THAT(reading_of_bytes("").refusal, HasSubstr("it is not a trajectory"));
    EXPECT_THAT(reading_of_bytes("step,time,particle\n").refusal, HasSubstr("it is not a trajectory"));
    EXPECT_THAT(reading_of_bytes(newer).refusal, HasSubstr("version"));
    EXPECT_THAT(reading_of_bytes(bytes_.substr(0, 20)).refusal, HasSubstr("damaged at its beginning"));
    for (const std::string& name : {std::string("/dev/null"), folder_.path(), folder_.file("missing")})
        EXPECT_THAT(reading_of(name).refusal, HasSubstr("cannot read '" + name + "'"));
}

}  // namespace
}  // namespace steplab
