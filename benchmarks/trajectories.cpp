// What writing trajectories takes: frames of a mesh that were computed before, fed to the writer of each format.
//
//     trajectories [PARTICLES [FRAMES [FILE]]]    FILE: where to (default /dev/null)

#include "io/temporary_folder.hpp"
#include "io/trajectory.hpp"
#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace steplab;

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds by the clock, of all threads together, and of the thread that feeds alone.
struct Seconds {
    double wall = 0, process = 0, feeding = 0;

    static Seconds now() {
        return {seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_PROCESS_CPUTIME_ID), seconds_of(CLOCK_THREAD_CPUTIME_ID)};
    }
};

/// The frame over and over with small differences, so that it has `particles` of which no two are alike.
Frame multiplied(const Frame& frame, std::size_t particles) {
    Frame large = frame;
    Shape shape;
    const auto factor_of = [&](std::size_t i) { return 1 + 1e-6 * static_cast<double>(i / frame.positions.size()); };
    const auto multiply = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
        to.clear();
        for (std::size_t i = 0; i < particles; ++i) {
            const Vec3 v = factor_of(i) * from[i % from.size()];
            to.push_back(
                {rounded_to(frame.precision, v.x), rounded_to(frame.precision, v.y), rounded_to(frame.precision, v.z)});
        }
    };
    multiply(frame.positions, large.positions);
    multiply(frame.velocities, large.velocities);
    shape.roles.assign(particles, Role::moving);
    large.shape = std::make_shared<const Shape>(std::move(shape));
    return large;
}

/// Moments of a rope on its way into a tangle: numbers with all their digits.
std::vector<Frame> frames_of(Precision precision, std::size_t particles) {
    constexpr std::size_t kept = 8;
    RunDescription description = describe("rope", "euler");
    description.scene.set("n", 1000);
    description.precision = precision;
    description.dt = 0.01;
    Simulation simulation(description);
    simulation.advance(5000);
    std::vector<Frame> frames;
    while (frames.size() < kept) {
        simulation.advance(1);
        frames.push_back(multiplied(simulation.frame(), particles));
    }
    return frames;
}

void write(const std::vector<Frame>& frames, std::size_t count, TrajectoryFormat format, OutputFile& file) {
    TrajectoryWriter writer(file, format, {});
    for (std::size_t i = 0; i < count; ++i) writer.add(frames[i % frames.size()]);
    writer.flush();
    file.flush();
}

double megabytes(const std::vector<Frame>& frames, TrajectoryFormat format) {
    const TemporaryFolder folder;
    const std::string name = folder.file("frames");
    OutputFile file(name);
    write(frames, frames.size(), format, file);
    file.commit();
    return 1e-6 * static_cast<double>(std::filesystem::file_size(name)) / static_cast<double>(frames.size());
}

void measure(const std::vector<Frame>& frames, std::size_t count, TrajectoryFormat format, const std::string& name,
             const std::string& place) {
    const double bytes = static_cast<double>(count) * megabytes(frames, format);
    const Seconds begin = Seconds::now();
    OutputFile file(place);
    write(frames, count, format, file);
    const Seconds end = Seconds::now();
    fmt::print("{:<12}{:<8}{:>8.1f} MB {:>8.1f} MB/s by the clock {:>8.1f} MB/s a core, feeding {:>4.1f} % of that\n",
               name, id(frames[0].precision), bytes, bytes / (end.wall - begin.wall),
               bytes / (end.process - begin.process),
               100 * (end.feeding - begin.feeding) / (end.process - begin.process));
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t particles = argc > 1 ? std::stoul(argv[1]) : 10000;
    const std::size_t count = argc > 2 ? std::stoul(argv[2]) : 100;
    const std::string place = argc > 3 ? argv[3] : "/dev/null";
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        const std::vector<Frame> frames = frames_of(precision, particles);
        for (int repeat = 0; repeat < 3; ++repeat) {
            measure(frames, count, TrajectoryFormat::csv, "csv", place);
            measure(frames, count, TrajectoryFormat::xyz, "xyz", place);
        }
    }
}
