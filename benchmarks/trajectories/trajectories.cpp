// What writing trajectories takes: frames of a mesh that were computed before, fed to the writer of each format.
//
//     trajectories [--lines] [PARTICLES [FRAMES [FILE [FORMAT]]]]
//         FILE: where to (default /dev/null); FORMAT: only this one; with --lines in lines for benchmarks/results: ns a
//         frame of all threads together, and a byte

#include "io/temporary_folder.hpp"
#include "io/trajectory.hpp"
#include "lines.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <cstdint>
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

/// A factor of its own for each number, between 0.5 and 1.5: digits without any pattern.
double factor(std::size_t i) {
    const std::uint64_t mixed = (i + 1) * 0x9e3779b97f4a7c15U;
    return 0.5 + 0x1p-53 * static_cast<double>((mixed ^ mixed >> 29) * 0xbf58476d1ce4e5b9U >> 11);
}

/// The particles of a frame over and over until there are so many, no two alike.
Frame multiplied(const Frame& frame, std::size_t particles) {
    Frame large = frame;
    const auto multiply = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
        to.clear();
        for (std::size_t i = 0; i < particles; ++i) {
            const Vec3 v = from[i % from.size()];
            to.push_back({rounded_to(frame.precision, factor(3 * i) * v.x),
                          rounded_to(frame.precision, factor(3 * i + 1) * v.y),
                          rounded_to(frame.precision, factor(3 * i + 2) * v.z)});
        }
    };
    multiply(frame.positions, large.positions);
    multiply(frame.velocities, large.velocities);
    large.displacements = large.positions;
    Shape shape;
    shape.roles.assign(particles, Role::moving);
    large.shape = std::make_shared<const Shape>(std::move(shape));
    return large;
}

RunDescription description(Precision precision) {
    RunDescription description = describe("morse", "euler");
    description.scene.set("edge", 6);
    description.precision = precision;
    description.dt = 0.01;
    return description;
}

/// Moments of a crystal that was hit, in all three directions.
std::vector<Frame> frames_of(Precision precision, std::size_t particles) {
    constexpr std::size_t kept = 8;
    Simulation simulation(description(precision));
    simulation.advance(1000);
    std::vector<Frame> frames;
    while (frames.size() < kept) {
        simulation.advance(1);
        frames.push_back(multiplied(simulation.frame(), particles));
    }
    return frames;
}

void write(const std::vector<Frame>& frames, std::size_t count, TrajectoryFormat format, OutputFile& file) {
    TrajectoryWriter writer(file, format, description(frames[0].precision), {});
    for (std::size_t i = 0; i < count; ++i) writer.add(frames[i % frames.size()]);
    writer.finish();
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

struct Written {
    std::string format;
    std::string_view precision;
    std::size_t frames, rows;  ///< rows of all frames
    double megabytes;
    Seconds spent;
};

Written measure(const std::vector<Frame>& frames, std::size_t count, const std::string& name,
                const std::string& place) {
    const TrajectoryFormat format = trajectory_format(name);
    const double size = static_cast<double>(count) * megabytes(frames, format);
    const Seconds begin = Seconds::now();
    OutputFile file(place);
    write(frames, count, format, file);
    const Seconds end = Seconds::now();
    return {name,  id(frames[0].precision),
            count, count * frames[0].positions.size(),
            size,  {end.wall - begin.wall, end.process - begin.process, end.feeding - begin.feeding}};
}

void print(const Written& file) {
    const auto& [format, precision, frames, rows, megabytes, spent] = file;
    const double millions = 1e-6 * static_cast<double>(rows);
    fmt::print(
        "{:<12}{:<8}{:>8.1f} MB, {:>5.1f} bytes a row: {:>7.1f} MB/s by the clock, {:>6.1f} MB/s or {:>5.2f} million "
        "rows a second and core, {:>4.1f} % of it on the thread that feeds\n",
        format, precision, megabytes, megabytes / millions, megabytes / spent.wall, megabytes / spent.process,
        millions / spent.process, 100 * spent.feeding / spent.process);
}

void print_lines(const Written& file) {
    const double frames = static_cast<double>(file.frames);
    benchmark::print({"writing-" + file.format, "-", file.precision, 1e6 * file.megabytes / frames, "steplab",
                      1e9 * file.spent.process / frames});
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool in_lines = benchmark::wants_lines(words);
    const std::size_t particles = words.empty() ? 10000 : std::stoul(words[0]);
    const std::size_t count = words.size() > 1 ? std::stoul(words[1]) : 100;
    const std::string place = words.size() > 2 ? words[2] : "/dev/null";
    const std::vector<std::string> formats =
        words.size() > 3 ? std::vector<std::string>{words[3]} : std::vector<std::string>{"csv", "xyz", "trajectory"};
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        const std::vector<Frame> frames = frames_of(precision, particles);
        for (int repeat = 0; repeat < 3; ++repeat) {
            for (const std::string& name : formats) {
                const Written file = measure(frames, count, name, place);
                in_lines ? print_lines(file) : print(file);
            }
        }
    }
}
