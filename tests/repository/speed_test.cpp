#include "speed.hpp"

#include "io/temporary_folder.hpp"
#include "speed_figures.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

namespace steplab::docs {
namespace {

using testing::HasSubstr;

constexpr const char* measured =
    "# processor: one of the kind\n"
    "row,method,precision,particles,who,ns_per_step,ns_per_particle,hash\n"
    "chain-10,rk4,double,10,steplab,100,10,0123\n"
    "chain-10,rk4,double,10,loops plain,400,40,\n"
    "chain-10,rk4,double,10,odeint gather,250,25,\n"
    "chain-10-ensemble,euler,double,10,steplab,90,9,45\n"
    "chain-10-ensemble,euler,double,10,steplab ensemble,30,3,\n"
    "growing-chain,velocity-verlet,double,10,steplab,50,5,45\n"
    "growing-chain,velocity-verlet,double,100000,steplab,400000,4,67\n"
    "growing-chain,velocity-verlet,double,100000,steplab 2 threads,250000,2.5,67\n"
    "growing-chain,velocity-verlet,double,100000,steplab 4 threads,200000,2,67\n"
    "machine-springs,-,double,1024,machine,1024,1,\n"
    "machine-springs,-,float,1024,machine,512,0.5,\n"
    "machine-memory,-,double,2048,machine,2048,1,\n"
    "error-chain,1e-06,double,10,steplab gauss-16 dt 2,50000,5000,89\n"
    "error-chain,1e-06,double,10,odeint fehlberg78 1e-7 plain,150000,15000,\n"
    "error-chain,1e-06,double,10,GSL rk8pd 1e-7 gather,100000,10000,\n"
    "error-chain,1e-14,double,10,steplab gauss-16 dt 1,90000,9000,ab\n"
    "drawing-10000,-,float,10000,steplab,20000000,2000,\n"
    "drawing-10000,-,float,10000,bare points,10000000,1000,\n"
    "watching-10000,velocity-verlet,double,10000,steplab watched,1000,0.1,\n"
    "watching-10000,velocity-verlet,double,10000,steplab,970,0.097,\n"
    "writing-csv,-,double,500000,steplab,2000000,4,\n"
    "writing-trajectory,-,float,500000,steplab,1000000,2,\n"
    "process-run-1000,-,double,1,steplab,3500000,3500000,\n"
    "process-run-1000,-,double,1,nothing,1200000,1200000,\n";

class SpeedTables : public testing::Test {
protected:
    void write(const std::string& text) { std::ofstream(folder_.file("some.csv")) << text; }
    std::vector<Results> results() const { return read_results(folder_.path()); }

    TemporaryFolder folder_;
};

TEST_F(SpeedTables, name_the_fastest_peer_and_the_goal) {
    write(measured);
    EXPECT_THAT(speed_tables(folder_.path()),
                HasSubstr("| chain-10 | `rk4` | double | 100.0 | 250.0 | odeint gather | 2.50 | 2.0 |"));
}

TEST_F(SpeedTables, mark_a_missed_goal) {
    write(
        "chain-10,rk4,double,10,steplab,100,10,0123\n"
        "chain-10,rk4,double,10,loops plain,199,19.9,\n"
        "chain-10,rk4,float,10,steplab,100,10,0123\n"
        "chain-10,rk4,float,10,loops plain,180,18,\n");
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, HasSubstr("| loops plain | 1.99 | 2.0 (missed) |"));
    EXPECT_THAT(text, HasSubstr("| loops plain | 1.80 | 1.8 |"));
}

TEST_F(SpeedTables, separate_times_per_step_from_times_per_particle_and_step) {
    write(
        "chain-10,rk4,double,10,steplab,100,10,0123\n"
        "chain-10,rk4,double,10,loops plain,400,40,\n"
        "mesh-100x100,rk4,double,10000,steplab,20000,2,45\n"
        "mesh-100x100,rk4,double,10000,loops plain,80000,8,\n");
    const std::string text = speed_tables(folder_.path());
    const auto large = text.find("Large scenes, time per particle and step:");
    ASSERT_NE(large, std::string::npos);
    EXPECT_LT(text.find("| chain-10 | `rk4` | double | 100.0 | 400.0 |"), large);
    EXPECT_GT(text.find("| mesh-100x100 | `rk4` | double | 2.00 | 8.00 |"), large);
}

TEST_F(SpeedTables, compare_morse_with_the_plain_force_too) {
    write(
        "morse-28,rk4,float,28,steplab,100,4,01\n"
        "morse-28,rk4,float,28,loops plain,900,30,\n"
        "morse-28,rk4,float,28,odeint gather,400,14,\n");
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, HasSubstr("| morse-28 | `rk4` | float | 100.0 | 900.0 | loops plain | 9.00 | 8.0 |"));
    EXPECT_THAT(text, HasSubstr("| morse-28 | `rk4` | float | 100.0 | 400.0 | odeint gather | 4.00 | 5.0 (missed) |"));
}

TEST_F(SpeedTables, have_the_speed_up_of_an_ensemble) {
    write(measured);
    EXPECT_THAT(speed_tables(folder_.path()), HasSubstr("| `euler` | double | 90.0 | 30.0 | 3.00 | 2.4 |"));
}

TEST_F(SpeedTables, have_the_speed_up_of_the_largest_number_of_threads) {
    write(measured);
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, HasSubstr("| 10 | 5.00 |  |  |"));
    EXPECT_THAT(text, HasSubstr("| 100000 | 4.00 | 2.00 (4 threads) | 2.00 | - |  |  |  |"));
}

TEST_F(SpeedTables, have_a_goal_for_two_threads) {
    write(
        "growing-mesh,velocity-verlet,double,100000,steplab,400000,4,67\n"
        "growing-chain,velocity-verlet,double,100000,steplab,400000,4,67\n"
        "growing-chain,velocity-verlet,double,100000,steplab 2 threads,250000,2.5,67\n");
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, HasSubstr("| 100000 | 4.00 | 2.50 (2 threads) | 1.60 | - |  |  | 1.8 (missed) |"));
    EXPECT_THAT(text, HasSubstr("| 100000 | 4.00 |  |  | - |  |  |  |"));
}

TEST_F(SpeedTables, compare_the_time_to_an_error_with_the_fastest_library) {
    write(measured);
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text,
                HasSubstr("| `chain` | 1e-06 | 50 | gauss-16, dt 2 | 100 | GSL rk8pd, tolerance 1e-7, gather | 2.00 "
                          "| 150 | 3.00 | 2.7 |"));
    EXPECT_THAT(text,
                HasSubstr("| `chain` | 1e-14 | 90 | gauss-16, dt 1 | - | none reaches the error | - | - | - |  |"));
}

TEST_F(SpeedTables, have_the_number_of_steps_of_a_fixed_method) {
    write(
        "error-mesh,1e-02,double,100,steplab pefrl dt 1e-05,22000,220,89\n"
        "error-mesh,1e-02,double,100,odeint adams 8 5e+02 plain,150000,1500,\n");
    EXPECT_THAT(speed_tables(folder_.path()),
                HasSubstr("| pefrl, dt 1e-05 | 150 | odeint adams 8, 500 steps, plain |"));
}

TEST_F(SpeedTables, have_rendering_files_and_processes) {
    write(measured);
    const std::string text = speed_tables(folder_.path());
    for (const char* line :
         {"| rendering, 10000 particles | 50.0 frames/s; 2.0 times as long as a bare `GL_POINTS` draw | "
          ">= 30 frames/s |",
          "| share of a run's time spent on views for the window, 10000 particles, double | 3.0 % | < 5 % |",
          "| writing `csv`, double, one core | 250 MB/s | >= 200 MB/s |",
          "| writing `trajectory`, float, one core | 500 MB/s |  |",
          "| `steplab run`, 1000 steps of 10 particles | 3.5 ms; `true` takes 1.2 ms | <= 15 ms |"})
        EXPECT_THAT(text, HasSubstr(line));
}

// Only what is measured in the same way is compared with steplab's steps.
TEST_F(SpeedTables, take_only_times_of_steps_as_peers) {
    write(measured);
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, testing::Not(HasSubstr("| drawing-10000 |")));
    EXPECT_THAT(text, testing::Not(HasSubstr("| error-chain |")));
    EXPECT_THAT(text, testing::Not(HasSubstr("| process-run-1000 |")));
}

// 2048 pairs of doubles are 32 KiB; three times 8 bytes per ns are 24 GB/s.
TEST_F(SpeedTables, have_the_limits_of_the_machine) {
    write(measured);
    const std::string text = speed_tables(folder_.path());
    EXPECT_THAT(text, HasSubstr("| square root and division, per number | 1.00 ns | 0.50 ns |"));
    EXPECT_THAT(text, HasSubstr("| bandwidth of y += c x over 32 KiB | 24 GB/s | 24 GB/s |"));
}

// A chain has a spring for each particle, which in double has 32 bytes of position and velocity along x, read and
// written.
TEST_F(SpeedTables, roofline_has_springs_per_second_against_springs_per_byte) {
    write(measured);
    const auto figures = speed_figures(results().front());
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[1].file, "speed-some-roofline.svg");
    const plot::Curve& reached = figures[1].figure.curves.front();
    EXPECT_THAT(reached.x, testing::ElementsAre(1.0 / 32));
    EXPECT_THAT(reached.y, testing::ElementsAre(0.25e9));
}

TEST_F(SpeedTables, have_no_diagrams_without_scaling) {
    write("chain-10,rk4,double,10,steplab,100,10,0123\n");
    EXPECT_TRUE(speed_figures(results().front()).empty());
    EXPECT_THAT(speed_tables(folder_.path()), testing::Not(HasSubstr("error")));
    EXPECT_THAT(speed_tables(folder_.path()), testing::Not(HasSubstr("files")));
}

TEST_F(SpeedTables, refuse_a_line_with_too_few_cells) {
    write("chain-10,rk4,double\n");
    EXPECT_THROW(results(), std::runtime_error);
}

}  // namespace
}  // namespace steplab::docs
