#include "core/error.hpp"
#include "io/trajectories.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>

namespace steplab {
namespace {

const TrajectoryFormat all_formats[] = {TrajectoryFormat::csv, TrajectoryFormat::xyz, TrajectoryFormat::trajectory};

TEST(TrajectoryFile, gives_back_every_bit_of_every_model_in_both_precisions) {
    for (const Model& model : models()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            RunDescription run = describe(model.info.id);
            run.precision = precision;
            const std::vector<Frame> frames = frames_of(run, 5);
            const Kept file(written(run, frames, TrajectoryFormat::trajectory));
            TrajectoryReader reader(InputFile(file.name()));
            EXPECT_TRUE(reader.complete());
            EXPECT_EQ(reader.run(), run) << model.info.id;
            EXPECT_TRUE(same_frames(read_all(reader), frames)) << model.info.id;
            for (const TrajectoryFormat format : all_formats)
                EXPECT_EQ(converted(reader, format), written(run, frames, format)) << model.info.id;
        }
    }
}

TEST(TrajectoryFile, gives_every_digit_of_displacements) {
    const Columns columns = parse_columns("ux,uy,uz,vx,x");
    for (const Model& model : models()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            RunDescription run = describe(model.info.id);
            run.precision = precision;
            run.dt = 0.01;
            const std::vector<Frame> frames = frames_of(run, 5);
            const Kept file(written(run, frames, TrajectoryFormat::trajectory));
            TrajectoryReader reader(InputFile(file.name()));
            const std::string text = written(run, frames, TrajectoryFormat::csv, {.columns = columns});
            EXPECT_EQ(converted(reader, TrajectoryFormat::csv, columns), text) << model.info.id;
            EXPECT_THAT(text, testing::StartsWith("step,time,particle,ux,uy,uz,vx,x\n"));
        }
    }
}

TEST(TrajectoryFile, of_a_long_chain_holds_displacements_that_positions_lose) {
    RunDescription run = describe("chain");
    run.precision = Precision::float_;
    run.scene.set("n", 5001);
    const std::vector<Frame> frames = frames_of(run, 2);
    const double moved = frames[1].displacements[5000].x, seen = frames[1].positions[5000].x - 10000;
    EXPECT_GT(moved, 0.1);
    EXPECT_NE(seen, moved);  // the spacing of floats near 10000 is 0.001
    EXPECT_NEAR(seen, moved, 0.0005);
    const Kept file(written(run, frames, TrajectoryFormat::trajectory));
    TrajectoryReader reader(InputFile(file.name()));
    EXPECT_EQ(read_all(reader)[1].displacements[5000].x, moved);
}

/// Files of steplab 0.2 have positions in place of displacements; their rows are those that it wrote as CSV itself.
TEST(TrajectoryFile, of_the_first_version_is_read) {
    const std::string folder = STEPLAB_SOURCE_DIR "/tests/io/";
    TrajectoryReader reader(InputFile(folder + "version_1.trajectory"));
    EXPECT_TRUE(reader.complete());
    EXPECT_EQ(reader.scene().mass, static_cast<double>(0.7F));
    EXPECT_EQ(converted(reader, TrajectoryFormat::csv), text_of(folder + "version_1.csv"));
    EXPECT_EQ(converted(reader, TrajectoryFormat::trajectory), text_of(folder + "version_1.trajectory"));
    EXPECT_NO_THROW(reader.require(usual_columns()));
    EXPECT_THROW(reader.require(parse_columns("ux")), FileError);
}

TEST(TrajectoryFile, holds_the_chosen_particles_by_their_numbers) {
    const RunDescription run = describe("chain");
    const std::vector<std::size_t> chosen{0, 1, 2, 7, 9};
    const std::vector<Frame> frames = frames_of(run, 3);
    const Kept file(written(run, frames, TrajectoryFormat::trajectory, {.particles = chosen}));
    TrajectoryReader reader(InputFile(file.name()));
    EXPECT_EQ(reader.rows(), chosen.size());
    EXPECT_EQ(read_all(reader)[0].positions.size(), chosen.size());
    for (const TrajectoryFormat format : all_formats)
        EXPECT_EQ(converted(reader, format), written(run, frames, format, {.particles = chosen}));
}

/// Frames of `particles` whose numbers identify frame and particle.
std::vector<Frame> counted_frames(std::size_t particles, std::size_t count) {
    Shape shape;
    shape.roles.assign(particles, Role::moving);
    Frame frame;
    frame.shape = std::make_shared<const Shape>(std::move(shape));
    frame.reference = {.count = particles};
    std::vector<Frame> frames;
    for (std::size_t k = 0; k < count; ++k) {
        frame.step = k * 3;
        frame.time = 0.1 * static_cast<double>(k);
        frame.positions.clear();
        for (std::size_t i = 0; i < particles; ++i)
            frame.positions.push_back({static_cast<double>(k), static_cast<double>(i), 0});
        frame.displacements = frame.velocities = frame.positions;
        frames.push_back(frame);
    }
    return frames;
}

TEST(TrajectoryFile, any_frame_is_found_whether_chunks_hold_many_or_pieces) {
    // 16384 rows are a chunk: many frames in one, just one, one and a row of the next, several chunks a frame.
    for (const std::size_t particles : {1000u, 16384u, 16385u, 40000u}) {
        const std::vector<Frame> frames = counted_frames(particles, 20);
        const Kept file(written(describe("chain"), frames, TrajectoryFormat::trajectory));
        TrajectoryReader reader(InputFile(file.name()));
        ASSERT_EQ(reader.frames(), frames.size());
        EXPECT_EQ(converted(reader, TrajectoryFormat::csv), written({}, frames, TrajectoryFormat::csv)) << particles;
        for (const std::size_t k : {19u, 0u, 7u, 16u, 15u, 17u}) {
            Frame frame;
            reader.frame(k, frame);
            EXPECT_EQ(bits_of(frame), bits_of(frames[k])) << particles << " particles, frame " << k;
        }
        Frame none;
        EXPECT_THROW(reader.frame(20, none), FileError);
    }
}

}  // namespace
}  // namespace steplab
