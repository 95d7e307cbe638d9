#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

constexpr std::string_view csv_head = "step,time,particle,x,y,z,vx,vy,vz";

/// The arguments of `steplab run` for this description, and more of them.
std::vector<std::string> arguments(const RunDescription& description, std::vector<std::string> more) {
    std::vector<std::string> all{"run"};
    for (const std::string& word : split(command_line(description), ' ')) all.push_back(word);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Every model with every method in one precision, at a dt at which all of them run for a few steps.
std::vector<RunDescription> all_runs(Precision precision) {
    std::vector<RunDescription> runs;
    for (const Method& method : methods()) {
        for (const Model* const model : test::models_for(method.info.id, precision)) {
            RunDescription run = describe(model->info.id, method.info.id);
            run.precision = precision;
            run.dt = 0.01;
            runs.push_back(run);
        }
    }
    return runs;
}

/// A printed number is the one the run holds, and no shorter text is: it reads back in the run's precision.
void expect_number(const std::string& text, double value, Precision precision) {
    if (precision == Precision::double_) {
        EXPECT_EQ(number<double>(text), value);
    } else {
        EXPECT_EQ(number<float>(text), static_cast<float>(value));
        EXPECT_LE(text.size(), std::string_view("-1.23456789e-38").size());  // never the 17 digits of a double
    }
}

void expect_row(const std::vector<std::string>& row, const Frame& frame, std::size_t particle) {
    ASSERT_EQ(row.size(), 9u);
    EXPECT_EQ(number<std::uint64_t>(row[0]), frame.step);
    EXPECT_EQ(number(row[1]), frame.time);
    EXPECT_EQ(number<std::size_t>(row[2]), particle);
    const Vec3 x = frame.positions[particle], v = frame.velocities[particle];
    const double values[] = {x.x, x.y, x.z, v.x, v.y, v.z};
    for (std::size_t i = 0; i < 6; ++i) expect_number(row[3 + i], values[i], frame.precision);
}

class Runs : public testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(Precision, Runs, testing::Values(Precision::float_, Precision::double_),
                         [](const auto& test) { return std::string(id(test.param)); });

TEST_P(Runs, rows_read_back_exactly) {
    for (const RunDescription& run : all_runs(GetParam())) {
        SCOPED_TRACE(command_line(run));
        const Outcome outcome = run_program(arguments(run, {"--steps", "5", "--every", "2", "--out", "-"}));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const CsvTable csv = table(outcome.out);
        EXPECT_EQ(csv.head, csv_head);
        Simulation simulation(run);
        std::size_t row = 0;
        for (const std::uint64_t step : {0U, 2U, 4U, 5U}) {
            simulation.advance(step - simulation.step());
            const Frame frame = simulation.frame();
            ASSERT_LE(row + frame.positions.size(), csv.rows.size());
            for (std::size_t i = 0; i < frame.positions.size(); ++i) expect_row(csv.rows[row++], frame, i);
        }
        EXPECT_EQ(row, csv.rows.size());
    }
}

TEST_P(Runs, extended_xyz_reads_back_exactly) {
    for (const RunDescription& run : all_runs(GetParam())) {
        SCOPED_TRACE(command_line(run));
        const Outcome outcome = run_program(arguments(run, {"--steps", "3", "--out", "-", "--format", "xyz"}));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::vector<std::string> lines = split(outcome.out, '\n');
        Simulation simulation(run);
        std::size_t line = 0;
        for (const std::uint64_t step : {0U, 3U}) {
            simulation.advance(step - simulation.step());
            const Frame frame = simulation.frame();
            EXPECT_EQ(number<std::size_t>(lines.at(line++)), frame.positions.size());
            EXPECT_THAT(lines.at(line),
                        HasSubstr("Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:masses:R:1:role:S:1 "));
            const std::string& comment = lines.at(line++);
            EXPECT_EQ(number(split(comment.substr(comment.find("Time=") + 5), ' ').front()), frame.time);
            for (std::size_t i = 0; i < frame.positions.size(); ++i) {
                const std::vector<std::string> words = split(lines.at(line++), ' ');
                ASSERT_EQ(words.size(), 12u);
                EXPECT_EQ(words[0], "X");
                EXPECT_EQ(words[11], id(frame.shape->roles[i]));
                expect_number(words[1], frame.positions[i].x, run.precision);
                expect_number(words[6], frame.velocities[i].z, run.precision);
            }
        }
        EXPECT_EQ(line, lines.size());
    }
}

TEST_P(Runs, series_reads_back_exactly) {
    const TemporaryFolder folder;
    for (const RunDescription& run : all_runs(GetParam())) {
        SCOPED_TRACE(command_line(run));
        const std::string file = folder.file("series.csv");
        ASSERT_EQ(run_program(arguments(run, {"--steps", "4", "--every", "3", "--series", file})).code, 0);
        const CsvTable csv = table(text_of(file));
        const bool exact = Simulation(run).has_exact();
        EXPECT_EQ(csv.head, std::string("step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,"
                                        "max_displacement,max_speed") +
                                (exact ? ",error" : ""));
        ASSERT_EQ(csv.rows.size(), 3u);
        Simulation simulation(run);
        const bool known = simulation.count_drag_work() || !has_drag(run);
        for (const auto& row : csv.rows) {
            simulation.advance(number<std::uint64_t>(row[0]) - simulation.step());
            const Diagnostics d = simulation.diagnostics();
            std::vector<double> values{simulation.time(),    d.kinetic,
                                       d.potential,          d.energy,
                                       d.energy_error,       d.momentum.x,
                                       d.momentum.y,         d.momentum.z,
                                       d.angular_momentum.x, d.angular_momentum.y,
                                       d.angular_momentum.z, d.max_displacement,
                                       d.max_speed};
            if (exact) values.push_back(*d.error);
            ASSERT_EQ(row.size(), values.size() + 1);
            constexpr std::size_t energy_error = 4;
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (i == energy_error && !known) {
                    EXPECT_EQ(row[i + 1], "") << "what drag takes is no error";
                } else {
                    EXPECT_EQ(number(row[i + 1]), values[i]) << i;
                }
            }
        }
    }
}

TEST_P(Runs, summary_agrees_with_the_simulation) {
    for (const RunDescription& run : all_runs(GetParam())) {
        SCOPED_TRACE(command_line(run));
        const Outcome outcome = run_program(arguments(run, {"--steps", "4", "--every", "1", "--summary", "-"}));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const Json summary = Json::parse(outcome.out);
        Simulation simulation(run);
        const double start = simulation.diagnostics().energy;
        const bool counted = simulation.count_drag_work(), change = has_drag(run) && !counted;
        double largest = 0;
        for (int i = 0; i < 4; ++i) {
            simulation.advance(1);
            largest = std::max(largest, std::abs(simulation.energy_error()));
        }
        EXPECT_EQ(summary.at("model"), run.model);
        EXPECT_EQ(summary.at("method"), run.method);
        EXPECT_EQ(summary.at("precision"), id(run.precision));
        EXPECT_EQ(summary.at("dt"), run.dt);  // 0.01 in float too: its shortest text
        EXPECT_EQ(summary.at("steps"), 4);
        EXPECT_EQ(summary.at("time"), simulation.time());
        EXPECT_EQ(summary.at("particles"), simulation.particles());
        EXPECT_EQ(summary.at("evaluations"), simulation.evaluations());
        EXPECT_EQ(summary.at("energy_start"), start);
        EXPECT_EQ(summary.at("energy_end"), simulation.diagnostics().energy);
        EXPECT_EQ(summary.at(change ? "energy_change" : "energy_error"), largest);
        EXPECT_EQ(summary.at("energy_error").is_null(), change);
        EXPECT_EQ(summary.contains("drag_work"), counted);
        EXPECT_EQ(summary.value("drag_work", 0.0), simulation.drag_work().value_or(0));
        const std::optional<double> error = simulation.diagnostics().error;
        EXPECT_EQ(summary.contains("error"), error.has_value());
        EXPECT_EQ(summary.value("error", 0.0), error.value_or(0));
        EXPECT_TRUE(summary.at("notes").empty());
        EXPECT_FALSE(summary.at("version").empty());
        EXPECT_FALSE(summary.at("commit").empty());
        EXPECT_EQ(summary.at("parameters").size(), run.scene.infos().size() + run.method_parameters.infos().size());
        EXPECT_GT(summary.at("wall_seconds"), 0);
        EXPECT_EQ(summary.at("hash"), simulation.hash());
        EXPECT_EQ(summary.at("status"), "ok");
        EXPECT_EQ(summary.size(), 18u + error.has_value() + has_drag(run));  // and nothing else
    }
}

Json summary_of(std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    words.insert(words.end(), {"--summary", "-"});
    return Json::parse(run_program(words).out);
}

class RunsOf : public testing::TestWithParam<test::MethodCase> {};

// More steps than lie between two checks of the energy.
TEST_P(RunsOf, each_method_are_the_same_whatever_every_is) {
    const std::vector<std::string> words{"--model", "morse", "--method", GetParam().id(),
                                         "--dt",    "0.003", "--steps",  "300"};
    const Json rare = summary_of(words);
    for (const char* every : {"1", "7", "300", "10000"}) {
        std::vector<std::string> often = words;
        often.insert(often.end(), {"--every", every, "--out", "/dev/null"});
        const Json frequent = summary_of(often);
        EXPECT_EQ(frequent.at("hash"), rare.at("hash")) << "every " << every;
        EXPECT_EQ(frequent.at("evaluations"), rare.at("evaluations")) << "every " << every;
    }
    std::vector<std::string> longer = words;
    longer.back() = "301";
    EXPECT_NE(summary_of(longer).at("hash"), rare.at("hash"));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, RunsOf, testing::ValuesIn(test::methods_where([](const test::MethodCase& c) {
                             return c.precision == Precision::double_;
                         })),
                         test::case_name);

TEST(Run, first_and_last_step_are_the_rows_by_default) {
    const auto rows = [](const char* steps) {
        return table(run_program({"run", "--steps", steps, "--particles", "0", "--out", "-"}).out).rows;
    };
    ASSERT_EQ(rows("7").size(), 2u);
    EXPECT_EQ(rows("7")[0][0], "0");
    EXPECT_EQ(rows("7")[1][0], "7");
    EXPECT_EQ(rows("0").size(), 1u);
    EXPECT_EQ(summary_of({}).at("steps"), 1000);
    EXPECT_EQ(summary_of({}).at("model"), "mesh");
}

TEST(Run, until_reaches_the_time_with_no_step_too_many) {
    EXPECT_EQ(summary_of({"--until", "10"}).at("steps"), 100);
    EXPECT_EQ(summary_of({"--until", "10.05"}).at("steps"), 101);
    EXPECT_EQ(summary_of({"--until", "0.3", "--dt", "0.1"}).at("steps"), 3);  // 0.3/0.1 is 2.9999999999999996 in binary
    EXPECT_EQ(summary_of({"--until", "0.7", "--dt", "0.7", "--precision", "float"}).at("steps"), 1);
    EXPECT_EQ(summary_of({"--until", "0"}).at("steps"), 0);
}

TEST(Run, only_the_chosen_particles_are_written_in_order) {
    const CsvTable csv = table(run_program({"run", "--steps", "1", "--particles", "9,0-2,1", "--out", "-"}).out);
    std::vector<std::string> particles;
    for (const auto& row : csv.rows) particles.push_back(row[0] + ':' + row[2]);
    EXPECT_THAT(particles, testing::ElementsAre("0:0", "0:1", "0:2", "0:9", "1:0", "1:1", "1:2", "1:9"));
}

TEST(Run, large_scenes_are_written_whole_and_in_order) {
    // 40000 rows a frame: each is made in several blocks on several threads
    const CsvTable csv =
        table(run_program({"run", "--set", "dim=200", "--steps", "2", "--every", "1", "--out", "-"}).out);
    ASSERT_EQ(csv.rows.size(), 3u * 40000u);
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
        ASSERT_EQ(number<std::size_t>(csv.rows[i][0]), i / 40000);
        ASSERT_EQ(number<std::size_t>(csv.rows[i][2]), i % 40000);
    }
}

TEST(Run, table_1_of_the_thesis_is_reproduced) {
    const std::pair<const char*, const char*> published[] = {
        {"euler", "25.7906"}, {"rk4", "25.7862"}, {"midpoint", "25.8029"}};
    for (const auto& [method, digits] : published) {
        const Outcome outcome =
            run_program({"run", "--model", "chain", "--set", "L=3", "--set", "v0=1", "--method", method, "--precision",
                         "float", "--dt", "0.1", "--steps", "681", "--particles", "9", "--out", "-"});
        const CsvTable csv = table(outcome.out);
        ASSERT_EQ(csv.rows.size(), 2u);
        // rounded to the four decimals that are printed there
        EXPECT_EQ(std::lround(number(csv.rows.back()[3]) * 1e4), std::lround(number(digits) * 1e4)) << method;
    }
}

TEST(Run, diverged_run_ends_with_its_last_valid_step) {
    const TemporaryFolder folder;
    const std::string file = folder.file("rows.csv");
    const Outcome outcome = run_program({"run", "--model", "chain", "--method", "euler", "--dt", "1.5", "--steps",
                                         "100000", "--every", "1", "--out", file, "--summary", "-"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("diverged"));
    EXPECT_THAT(outcome.err, HasSubstr("1.5"));
    const Json summary = Json::parse(outcome.out);
    EXPECT_EQ(summary.at("status"), "diverged");
    EXPECT_LT(summary.at("steps"), 100000);
    EXPECT_EQ(summary.at("diverged_step"), summary.at("steps").get<int>() + 1);
    const CsvTable csv = table(text_of(file));
    EXPECT_EQ(number<int>(csv.rows.back()[0]), summary.at("steps"));
    for (const auto& row : csv.rows) {
        for (const std::string& field : row) EXPECT_TRUE(std::isfinite(number(field)));
    }
    // The same run below its limit is fine: 1.0138 for ten points.
    EXPECT_EQ(run_program({"run", "--model", "chain", "--method", "euler", "--dt", "1", "--steps", "1000"}).code, 0);
}

TEST(Run, divergence_does_not_depend_on_every) {
    const std::vector<std::string> words{"--model", "chain", "--method", "rk4", "--dt", "1.6", "--steps", "100000"};
    const Json rare = summary_of(words);
    for (const char* every : {"1", "3", "1000"}) {
        std::vector<std::string> often = words;
        often.insert(often.end(), {"--every", every});
        EXPECT_EQ(summary_of(often).at("steps"), rare.at("steps")) << every;
        EXPECT_EQ(summary_of(often).at("hash"), rare.at("hash")) << every;
    }
}

TEST(Run, numbers_that_are_not_finite_are_null) {
    const Json summary = summary_of({"--model", "chain", "--set", "v0=1e200", "--steps", "1"});
    EXPECT_TRUE(summary.at("energy_start").is_null());  // its square is beyond double
}

TEST(Run, summary_for_people_leaves_standard_output_to_the_data) {
    const std::vector<std::string> words{"run", "--model", "oscillator", "--steps", "3"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), words.begin(), words.end());
        return run_program(more);
    };
    EXPECT_THAT(with({}).out, HasSubstr("oscillator with rk4"));
    EXPECT_EQ(with({}).err, "");
    EXPECT_THAT(with({"--out", "-"}).err, HasSubstr("oscillator with rk4"));
    EXPECT_THAT(with({"--out", "-"}).out, testing::StartsWith("step,"));
    EXPECT_THAT(with({"--summary", "-"}).err, HasSubstr("oscillator with rk4"));
    EXPECT_THAT(with({"--summary", "-"}).out, testing::StartsWith("{"));
}

TEST(Run, energy_that_drag_takes_is_no_error) {
    const auto summary = [](const char* drag) {
        return run_program({"run", "--model", "rope", "--steps", "5", "--set", drag}).out;
    };
    EXPECT_THAT(summary("c=0.3"), testing::AllOf(HasSubstr("energy change"), testing::Not(HasSubstr("energy error"))));
    EXPECT_THAT(summary("c=0"), testing::AllOf(HasSubstr("energy error"), testing::Not(HasSubstr("energy change"))));
}

TEST(Run, memory_does_not_grow_with_the_number_of_steps) {
    const auto kilobytes = [](const char* steps) {
        const Outcome outcome =
            run_program({"run", "--model", "chain", "--steps", steps, "--every", "10", "--out", "/dev/null", "--series",
                         "/dev/null"},
                        {.environment = {"ASAN_OPTIONS=quarantine_size_mb=1"}});  // a sanitizer keeps what is freed
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.kilobytes;
    };
    // The longer run writes 70 MB. Both reach the same few blocks in flight; 16 MB is room for chance.
    EXPECT_LT(kilobytes("1000000"), kilobytes("100000") + 16 * 1024);
}

}  // namespace
}  // namespace steplab
