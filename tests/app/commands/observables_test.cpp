// What `run --observables` adds to a time series, and what `observe --rdf` prints, against sums over the written rows.

#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;

class ObservablesOfRuns : public testing::Test {
protected:
    std::string file(const std::string& name) const { return folder_.file(name); }
    /// A scene file with these blocks.
    std::string scene(const std::string& name, const std::string& blocks) const {
        put_text(file(name), "steplab = 1\n" + blocks);
        return file(name);
    }
    static std::string done(const std::vector<std::string>& words) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
    static void expect_refused(const std::vector<std::string>& words, int code, const std::string& message) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(message));
    }
    TemporaryFolder folder_;
};

const std::string three_in_liquid = R"(
[[particles]]
group = "a"
velocity = [1, 0, 0]
mass = 2
[[particles]]
group = "b"
position = [1.5, 0.5, 0]
velocity = [0, -0.5, 0.25]
mass = 3
[[particles]]
group = "c"
position = [5.5, 5, 0]
velocity = [-0.5, 0.5, -0.25]
[[pairs]]
potential = "lennard-jones"
epsilon = 1
sigma = 1.2
cutoff = 2
)";
constexpr std::array masses_of_three{2.0, 3.0, 1.0};
constexpr double side_of_three = 6, cutoff_of_three = 2;

/// -r V'(r) of that potential, 0 at the cut-off.
double virial_of(double r) {
    const auto slope = [](double at) {
        const double s6 = std::pow(1.2 / at, 6);
        return 24 * (s6 - 2 * s6 * s6) / at;
    };
    return r < cutoff_of_three ? -r * (slope(r) - slope(cutoff_of_three)) : 0;
}

/// A frame of rows with the columns step, time, particle, x, y, z, vx, vy, vz.
struct WrittenFrame {
    std::array<std::array<double, 3>, 3> at, velocity;
};
std::vector<WrittenFrame> frames_of_rows(const CsvTable& rows) {
    std::vector<WrittenFrame> frames(rows.rows.size() / 3);
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            frames[r / 3].at[r % 3][axis] = number(rows.rows[r][3 + axis]);
            frames[r / 3].velocity[r % 3][axis] = number(rows.rows[r][6 + axis]);
        }
    }
    return frames;
}

double virial_of(const WrittenFrame& frame, bool periodic) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            double r2 = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double d = frame.at[j][axis] - frame.at[i][axis];
                if (periodic) d -= side_of_three * std::round(d / side_of_three);
                r2 += d * d;
            }
            sum += virial_of(std::sqrt(r2));
        }
    }
    return sum;
}

/// Twice the kinetic energy about the centre of mass by 3 n - 3 degrees of freedom.
double temperature_of(const WrittenFrame& frame) {
    double twice = 0, mass = 0;
    for (const double m : masses_of_three) mass += m;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double mean = 0;
        for (std::size_t i = 0; i < 3; ++i) mean += masses_of_three[i] * frame.velocity[i][axis] / mass;
        for (std::size_t i = 0; i < 3; ++i) twice += masses_of_three[i] * std::pow(frame.velocity[i][axis] - mean, 2);
    }
    return twice / 6;
}

double displacement_of(const WrittenFrame& frame, const WrittenFrame& first) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum += std::pow(frame.at[i][axis] - first.at[i][axis], 2);
    }
    return sum / 3;
}

// Numbers of 17 digits; sums of a few products and powers of 12: some 1e-14 of terms up to a hundred.
TEST_F(ObservablesOfRuns, are_the_sums_over_the_rows_of_the_same_run) {
    for (const std::string method : {"velocity-verlet", "rk4"}) {
        const std::string box = scene("box.toml", three_in_liquid + "[box]\nsize = [6, 6, 6]\n");
        done({"run", "--scene", box, "--method", method, "--dt", "0.01", "--steps", "40", "--every", "10", "--out",
              file("rows.csv"), "--series", file("series.csv"), "--observables", "kT,pressure,msd"});
        const CsvTable series = table(text_of(file("series.csv")));
        EXPECT_THAT(series.head, testing::EndsWith(",max_speed,kT,pressure,msd"));
        const std::vector<WrittenFrame> frames = frames_of_rows(table(text_of(file("rows.csv"))));
        ASSERT_EQ(frames.size(), 5u);
        ASSERT_EQ(series.rows.size(), 5u);
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const std::vector<std::string>& row = series.rows[f];
            const std::size_t kT = row.size() - 3;
            EXPECT_NEAR(number(row[kT]), temperature_of(frames[f]), 1e-12) << method << f;
            const double pressure = (3 * temperature_of(frames[f]) + virial_of(frames[f], true) / 3) /
                                    (side_of_three * side_of_three * side_of_three);
            EXPECT_NEAR(number(row[kT + 1]), pressure, 1e-12) << method << f;
            EXPECT_NEAR(number(row[kT + 2]), displacement_of(frames[f], frames[0]), 1e-12) << method << f;
        }
        EXPECT_NEAR(number(series.rows[0].end()[-3]), 175.0 / 360, 1e-15) << "by hand: (3.5 - 3.5 / 6) / 6";
        EXPECT_GT(std::abs(virial_of(frames[0], true) - virial_of(frames[0], false)), 0.1) << "images count";
        EXPECT_GT(number(series.rows[4].end()[-1]), 0.01) << "they move";
    }
}

// In open space there is no pressure: an empty field. With one held, all directions of the others count.
TEST_F(ObservablesOfRuns, have_the_columns_and_the_order_that_are_asked_for) {
    const std::string open = scene("open.toml", three_in_liquid + "[[fix]]\nparticles = \"b\"\nfixed = true\n");
    done({"run", "--scene", open, "--method", "rk4", "--dt", "0.01", "--steps", "2", "--every", "1", "--series",
          file("s.csv"), "--observables", "msd,pressure,kT"});
    const CsvTable series = table(text_of(file("s.csv")));
    EXPECT_THAT(series.head, testing::EndsWith(",max_speed,msd,pressure,kT"));
    ASSERT_EQ(series.rows.size(), 3u);
    for (const auto& row : series.rows) EXPECT_EQ(row.end()[-2], "");
    EXPECT_NEAR(number(series.rows[0].back()), (2 * 1 + 1 * 0.5625) / 6, 1e-15);
    done({"run", "--scene", open, "--steps", "1", "--series", file("plain.csv")});
    EXPECT_THAT(table(text_of(file("plain.csv"))).head, testing::EndsWith(",max_speed"));
}

TEST_F(ObservablesOfRuns, that_cannot_be_are_refused) {
    const std::string box = scene("box.toml", three_in_liquid + "[box]\nsize = [6, 6, 6]\n");
    expect_refused({"run", "--scene", box, "--steps", "1", "--observables", "kT"}, 2, "there is no --series");
    expect_refused({"run", "--scene", box, "--steps", "1", "--series", file("s.csv"), "--observables", "kT,heat"}, 2,
                   "unknown observable 'heat'; known: kT, pressure, msd");
    expect_refused(
        {"run", "--scene", box, "--steps", "1", "--series", file("s.csv"), "--observables", "kT", "--ensemble", "3"}, 2,
        "--observables are those of one run");
}

/// r and g of `observe --rdf`.
std::vector<std::array<double, 2>> radial_rows(const std::string& text) {
    const CsvTable rows = table(text);
    EXPECT_EQ(rows.head, "r,g");
    std::vector<std::array<double, 2>> all;
    for (const auto& row : rows.rows) all.push_back({number(row.at(0)), number(row.at(1))});
    return all;
}

/// What pairs at distances would make in a bin: how often per pair, compared with a gas of the same density.
double ratio_to_ideal(double part_of_pairs, double from, double to, double side_of_box) {
    const double shell = 4 * std::numbers::pi / 3 * (to * to * to - from * from * from);
    return part_of_pairs * side_of_box * side_of_box * side_of_box / shell;
}

// A cubic lattice of 5^3 that moves through its box as a whole has the shells of 6, 12, 8, 6, 24 and 24 neighbours,
// whichever file its frames are in.
TEST_F(ObservablesOfRuns, shells_of_a_lattice_are_in_its_radial_distribution) {
    const std::string lattice = scene("lattice.toml",
                                      "[[particles]]\nlattice = { kind = \"cubic\", cells = [5, 5, 5], constant = 1 }\n"
                                      "velocity = [0.3, 0.2, 0.1]\n[box]\nsize = [5, 5, 5]\n");
    done({"run", "--scene", lattice, "--dt", "1", "--steps", "6", "--every", "1", "--out", file("l.trajectory")});
    const std::string printed = done({"observe", file("l.trajectory"), "--rdf", "--bins", "31"});
    const auto found = radial_rows(printed);
    ASSERT_EQ(found.size(), 31u);
    const double width = 2.5 / 31;
    const std::vector<std::array<double, 2>> shells{{1, 6}, {std::sqrt(2.0), 12}, {std::sqrt(3.0), 8},
                                                    {2, 6}, {std::sqrt(5.0), 24}, {std::sqrt(6.0), 24}};
    double neighbours = 0;
    for (std::size_t bin = 0; bin < found.size(); ++bin) {
        const double from = static_cast<double>(bin) * width, to = from + width;
        EXPECT_NEAR(found[bin][0], from + width / 2, 1e-14);
        double right = 0;
        for (const auto& [r, count] : shells) {
            if (r >= from && r < to) right += ratio_to_ideal(count / 124, from, to, 5);
        }
        EXPECT_NEAR(found[bin][1], right, 1e-12 * (1 + right)) << bin;
        neighbours += right > 0 ? 1 : 0;
    }
    EXPECT_EQ(neighbours, 6);
    done({"convert", file("l.trajectory"), "--out", file("l.xyz")});
    EXPECT_EQ(done({"observe", file("l.xyz"), "--rdf", "--bins", "31"}), printed);
    done({"observe", file("l.trajectory"), "--rdf", "--bins", "31", "--out", file("rdf.csv")});
    EXPECT_EQ(text_of(file("rdf.csv")), printed);
    EXPECT_EQ(radial_rows(done({"observe", file("l.trajectory"), "--rdf"})).size(), 200u);
}

// Two particles 1, 1.5 and 2 apart in three frames, one of them through the wall: a third in each bin.
TEST_F(ObservablesOfRuns, radial_distribution_is_averaged_over_frames) {
    const std::string two = scene("two.toml",
                                  "[[particles]]\n[[particles]]\nposition = [7, 0, 0]\nvelocity = [-0.5, 0, 0]\n"
                                  "[box]\nsize = [8, 8, 8]\n");
    done({"run", "--scene", two, "--dt", "1", "--steps", "2", "--every", "1", "--out", file("two.trajectory")});
    const auto found = radial_rows(done({"observe", file("two.trajectory"), "--rdf", "--bins", "9"}));
    ASSERT_EQ(found.size(), 9u);
    const double width = 4.0 / 9;  // 1, 1.5 and 2 lie in the bins 2, 3 and 4
    for (std::size_t bin = 0; bin < 9; ++bin) {
        const double from = static_cast<double>(bin) * width, to = from + width;
        const double right = bin >= 2 && bin <= 4 ? ratio_to_ideal(1.0 / 3, from, to, 8) : 0;
        EXPECT_NEAR(found[bin][1], right, 1e-12 * (1 + right)) << bin;
    }
}

TEST_F(ObservablesOfRuns, radial_distribution_needs_a_box) {
    for (const std::string box : {"", "[box]\nsize = [6, 6, 0]\n"}) {
        const std::string name = scene("open.toml", three_in_liquid + box);
        done({"run", "--scene", name, "--steps", "1", "--dt", "0.01", "--out", file("o.trajectory")});
        expect_refused({"observe", file("o.trajectory"), "--rdf"}, 3, "has no periodic box along all three axes");
        expect_refused({"observe", file("o.trajectory")}, 2, "--rdf is required");
    }
}

}  // namespace
}  // namespace steplab
