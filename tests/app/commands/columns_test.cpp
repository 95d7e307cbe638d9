#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace steplab {
namespace {

using testing::HasSubstr;

class ColumnsOfFiles : public testing::Test {
protected:
    /// The rows of a run in this file, as text.
    std::string run_to(const std::string& name, std::vector<std::string> words) const {
        words.insert(words.begin(), "run");
        words.insert(words.end(), {"--out", folder_.file(name)});
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return text_of(folder_.file(name));
    }
    std::string convert(const std::string& from, std::vector<std::string> words) const {
        words.insert(words.begin(), {"convert", folder_.file(from)});
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
    TemporaryFolder folder_;
};

TEST_F(ColumnsOfFiles, of_a_trajectory_are_those_of_the_run_for_every_model_in_both_precisions) {
    for (const Model& model : models()) {
        for (const std::string precision : {"float", "double"}) {
            const std::vector<std::string> scene{"--model",     std::string(model.info.id),
                                                 "--precision", precision,
                                                 "--dt",        "0.01",
                                                 "--steps",     "30",
                                                 "--every",     "10"};
            auto with_columns = scene;
            with_columns.insert(with_columns.end(), {"--columns", "ux,uy,uz"});
            const std::string direct = run_to("a.csv", with_columns);
            run_to("a.trajectory", scene);
            EXPECT_EQ(convert("a.trajectory", {"--columns", "ux,uy,uz"}), direct) << model.info.id << ' ' << precision;
        }
    }
}

TEST_F(ColumnsOfFiles, show_how_far_a_particle_far_away_has_moved) {
    const std::string rows =
        run_to("a.csv", {"--model", "chain", "--set", "n=5001", "--set", "v0=0.001", "--precision", "float", "--steps",
                         "4", "--columns", "x,ux", "--series", folder_.file("s.csv")});
    double largest = 0;
    std::string position;
    for (const auto& row : table(rows).rows) {
        if (row[0] != "4") continue;
        largest = std::max(largest, std::abs(static_cast<double>(number<float>(row[4]))));
        position = row[3];
    }
    EXPECT_EQ(largest, number(table(text_of(folder_.file("s.csv"))).rows.back()[12]));  // max_displacement
    EXPECT_GT(largest, 1e-4);
    EXPECT_EQ(position, "10000");  // floats near 10000 are 0.001 apart
}

TEST_F(ColumnsOfFiles, of_an_ensemble_are_those_of_its_runs) {
    const std::vector<std::string> scene{"--model",   "rope",  "--steps",     "20",
                                         "--columns", "uy,vx", "--particles", "1,3"};
    auto ensemble = scene;
    ensemble.insert(ensemble.end(), {"--ensemble", "2", "--spread", "g=9.81:9.81"});
    const CsvTable single = table(run_to("a.csv", scene)), both = table(run_to("b.csv", ensemble));
    EXPECT_EQ(both.head, "run,step,time,particle,uy,vx");
    ASSERT_EQ(both.rows.size(), 2 * single.rows.size());
    for (std::size_t i = 0; i < both.rows.size(); ++i)
        EXPECT_EQ(std::vector<std::string>(both.rows[i].begin() + 1, both.rows[i].end()),
                  single.rows[i % single.rows.size()]);
}

TEST_F(ColumnsOfFiles, wrong_ones_are_refused_with_the_known_ones) {
    run_to("a.trajectory", {"--model", "chain"});
    const std::string trajectory = folder_.file("a.trajectory"), out = folder_.file("b.csv");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"run", "--out", out, "--columns", "x,w"}, {"convert", trajectory, "--out", out, "--columns", "x,w"}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, HasSubstr("unknown column 'w'; known: x, y, z, vx, vy, vz, ux, uy, uz"));
    }
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"run", "--columns", "x"},
             {"run", "--out", out, "--columns", "x,x"},
             {"run", "--out", folder_.file("b.xyz"), "--columns", "x,y,z,vx"},
             {"run", "--out", folder_.file("b.xyz"), "--columns", "ux,uy,uz"},
             {"run", "--out", folder_.file("b.trajectory"), "--columns", "x"},
             {"convert", trajectory, "--out", folder_.file("b.trajectory"), "--columns", "x"},
             {"run", "--out", folder_.file("b.trajectory.gz")},
             {"convert", trajectory, "--out", folder_.file("b.trajectory.zst")}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(words);
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(ColumnsOfFiles, are_not_in_a_file_of_the_first_version) {
    const std::string old = STEPLAB_SOURCE_DIR "/tests/io/version_1.trajectory";
    const Outcome outcome = run_program({"convert", old, "--columns", "ux"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("it holds no displacements (ux, uy, uz): its format is version 1"));
    EXPECT_EQ(run_program({"convert", old}).out, text_of(STEPLAB_SOURCE_DIR "/tests/io/version_1.csv"));
}

/// Each ending with the tool that undoes it.
TEST_F(ColumnsOfFiles, are_compressed_by_the_ending_and_read_again) {
    const std::vector<std::string> scene{"--model", "rope", "--steps", "400", "--every", "2"};
    for (const std::string format : {"csv", "xyz", "extxyz"}) {
        const std::string plain = run_to("a." + format, scene);
        for (const std::string compression : {"gz", "zst"}) {
            const std::string name = "b." + format + "." + compression;
            const std::string small = run_to(name, scene);
            EXPECT_LT(small.size(), plain.size() / 2);
            EXPECT_EQ(convert(name, {"--format", format == "csv" ? "csv" : "xyz"}), plain);
            convert("a." + format, {"--out", folder_.file("c." + format + "." + compression)});
            EXPECT_EQ(convert("c." + format + "." + compression, {"--format", format == "csv" ? "csv" : "xyz"}), plain);
            for (const std::size_t kept : {small.size() - 1, small.size() / 2, std::size_t{10}}) {
                put_text(folder_.file("cut.gz"), small.substr(0, kept));
                std::filesystem::remove(folder_.file("d.csv"));
                const Outcome outcome =
                    run_program({"convert", folder_.file("cut.gz"), "--out", folder_.file("d.csv")});
                EXPECT_EQ(outcome.code, 3);
                EXPECT_THAT(outcome.err, HasSubstr("its compressed data is truncated"));
                const bool written = std::filesystem::exists(folder_.file("d.csv"));
                EXPECT_EQ(written, outcome.err.find("written") != std::string::npos) << outcome.err;
                EXPECT_FALSE(written && kept == 10) << "there is no frame in it";
                if (written && format == "csv") {
                    EXPECT_TRUE(plain.starts_with(text_of(folder_.file("d.csv"))));
                }
            }
        }
    }
}

TEST_F(ColumnsOfFiles, dumps_are_compressed_by_the_ending_and_read_again) {
    run_to("a.trajectory", {"--model", "rope", "--steps", "40", "--every", "4"});
    const std::string dump = convert("a.trajectory", {"--format", "dump"});
    EXPECT_THAT(dump, testing::StartsWith("ITEM: TIME\n0\nITEM: TIMESTEP\n0\n"));
    for (const std::string name : {"b.dump.gz", "b.dump.zst", "b.lammpstrj.gz", "b.lammpstrj.zst"}) {
        convert("a.trajectory", {"--out", folder_.file(name)});
        const std::string small = text_of(folder_.file(name));
        EXPECT_LT(small.size(), dump.size() / 2) << name;
        EXPECT_EQ(convert(name, {"--format", "dump"}), dump) << name;
        put_text(folder_.file("cut.dump.gz"), small.substr(0, small.size() / 2));
        EXPECT_EQ(run_program({"convert", folder_.file("cut.dump.gz"), "--out", folder_.file("d.csv")}).code, 3);
    }
}

TEST_F(ColumnsOfFiles, series_and_summary_are_compressed_by_the_ending_too) {
    const std::string series = folder_.file("s.csv"), summary = folder_.file("j.json");
    for (const std::string ending : {"", ".gz"})
        run_to("a.csv", {"--model", "rope", "--steps", "100", "--every", "1", "--series", series + ending, "--summary",
                         summary + ending});
    ASSERT_EQ(std::system(("gzip -dc " + series + ".gz | cmp - " + series).c_str()), 0);
    ASSERT_EQ(std::system(("gzip -dc " + summary + ".gz | grep -q '\"status\": \"ok\"'").c_str()), 0);
}

TEST_F(ColumnsOfFiles, text_does_not_become_a_trajectory) {
    run_to("a.csv", {"--model", "chain"});
    const Outcome outcome = run_program({"convert", folder_.file("a.csv"), "--out", folder_.file("a.trajectory")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("does not describe its run"));
}

}  // namespace
}  // namespace steplab
