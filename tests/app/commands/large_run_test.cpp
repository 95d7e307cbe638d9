#include "app/program.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

// The whole process. Its programs and libraries are some 8 MB: 4 bytes a particle.
TEST(LargeRun, takes_little_more_memory_than_positions_and_velocities) {
    const auto bytes_a_particle = [](double particles, const char* model, const char* size, const char* method) {
        const Outcome outcome =
            run_program({"run", "--model", model, "--set", size, "--method", method, "--steps", "3", "--threads", "2"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return static_cast<double>(outcome.kilobytes) * 1024 / particles;
    };
    EXPECT_LT(bytes_a_particle(2.25e6, "mesh", "dim=1500", "velocity-verlet"), 64);
    EXPECT_LT(bytes_a_particle(2.25e6, "chain", "n=2250000", "pefrl"), 64);
    EXPECT_LT(bytes_a_particle(2.25e6, "mesh", "dim=1500", "rk4"), 200);
    EXPECT_GT(bytes_a_particle(2.25e6, "mesh", "dim=1500", "rk4"), 96);  // there is something to be measured
    EXPECT_LT(bytes_a_particle(1e6, "crystal", "edge=100", "velocity-verlet"), 400);  // lists of pairs are most of it
}

}  // namespace
}  // namespace steplab
