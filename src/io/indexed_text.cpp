#include "io/indexed_text.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"
#include "io/scene_file.hpp"
#include "io/temporary_folder.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory.hpp"

#include <fmt/format.h>

#include <utility>

namespace steplab {

namespace {

constexpr const char* unknown_scene =
    "steplab = 1\n"
    "title = \"Particles of a file\"\n"
    "teaches = \"Positions and velocities of a file that does not describe its run.\"\n"
    "[[particles]]\n"
    "position = [0, 0, 0]\n";

/// As a run has it whose reference positions are all the origin.
Frame frame_of(FrameBlock block) {
    Frame frame;
    frame.step = block.moments.front().step;
    frame.time = block.moments.front().time;
    frame.velocities = std::move(block.velocities);
    frame.velocities.resize(block.rows);
    frame.displacements = std::move(block.positions);
    frame.reference = {.count = block.rows};
    Shape shape;
    shape.roles = std::move(block.roles);
    shape.roles.resize(block.rows, Role::moving);
    shape.box = block.scene.box;
    shape.corner = block.scene.corner;
    frame.shape = std::make_shared<const Shape>(std::move(shape));
    return frame;
}

/// Adds frame after frame up to the end or the first fault, which it returns.
std::string copy_frames(TextTrajectory& text, TrajectoryWriter& writer) {
    FrameBlock block, next;
    std::string fault;
    bool is_there = text.next(block), has_times = true;
    for (std::uint64_t number = 0; is_there; ++number) {
        check_interruption();
        try {  // the next one tells whether there are times
            is_there = text.next(next);
        } catch (const FileError& why) {
            fault = why.what();
            is_there = false;
        }
        FrameBlock::Moment& moment = block.moments.front();
        if (number == 0 && is_there) has_times = moment.time != next.moments.front().time;
        if (!has_times) moment.time = static_cast<double>(moment.step);
        const std::size_t rows = block.rows;
        writer.add(frame_of(std::move(block)));
        if (is_there && next.rows != rows)
            return fmt::format("frame {} has {} rows, the ones before {}", number + 1, next.rows, rows);
        std::swap(block, next);
    }
    return fault;
}

}  // namespace

RunDescription unknown_run(const std::string& file) {
    return describe(scene_from({{.name = "", .content = unknown_scene}}, file));
}

IndexedText indexed(InputFile input) {
    const std::string name = input.name();
    const auto text = TextTrajectory::open(TextInput(std::move(input)), TextTrajectory::From::any_program);
    text->require({Column::x, Column::y, Column::z});
    const TemporaryFolder folder;  // an open file stays when its folder is removed
    const std::string path = folder.file("frames");
    std::string fault;
    {
        OutputFile file(path);
        TrajectoryWriter writer(file, TrajectoryFormat::trajectory, unknown_run(name));
        fault = copy_frames(*text, writer);
        writer.finish();
        file.commit();
    }
    if (InputFile(path).size() == 0) {
        if (!fault.empty()) throw FileError(fault);
        throw FileError(fmt::format("cannot read '{}': it holds no frame", shown(name)));
    }
    return {TrajectoryReader(InputFile(path)), std::move(fault)};
}

}  // namespace steplab
