// Scenes computed by LAMMPS from the command line: export --to lammps, cluster, crosscheck.

#include "app/commands/cluster_results.hpp"
#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "support/runs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

const std::vector<std::string> small_mesh{"--model", "mesh", "--method", "velocity-verlet", "--steps", "50"};

Outcome steplab(std::vector<std::string> words, const std::vector<std::string>& more, const Surroundings& where = {}) {
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, where);
}

/// A folder with a program of this name; PATH then has it and the system's shell.
void put_program(const TemporaryFolder& folder, const std::string& name, const std::string& script) {
    put_text(folder.file(name), "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder.file(name), std::filesystem::perms::owner_all);
}

TEST(Cluster, gives_the_rows_and_the_summary_of_run) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    const Outcome there =
        steplab({"cluster", "--ranks", "2", "--every", "20", "--out", "there.csv", "--summary", "-"}, small_mesh, here);
    ASSERT_EQ(there.code, 0) << there.err;
    ASSERT_EQ(steplab({"run", "--every", "20", "--out", "ours.csv"}, small_mesh, here).code, 0);
    const CsvTable theirs = table(text_of(folder.file("there.csv"))), ours = table(text_of(folder.file("ours.csv")));
    EXPECT_EQ(theirs.head, ours.head);
    ASSERT_EQ(theirs.rows.size(), ours.rows.size());
    EXPECT_EQ(theirs.rows.size(), 400U) << "steps 0, 20, 40 and 50";
    for (std::size_t row = 0; row < ours.rows.size(); ++row) {
        for (std::size_t column = 0; column < ours.rows[row].size(); ++column)
            ASSERT_NEAR(number(theirs.rows[row][column]), number(ours.rows[row][column]), 1e-12)
                << "sums of forces in another order, 50 times";
    }
    const Json summary = Json::parse(there.out);
    EXPECT_EQ(summary["method"], "velocity-verlet");
    EXPECT_EQ(summary["steps"], 50);
    EXPECT_EQ(summary["status"], "ok");
    EXPECT_NEAR(summary["energy_start"].get<double>(), 0.5, 1e-12);
    EXPECT_THAT(summary["notes"].dump(), HasSubstr("on 2 MPI ranks"));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_FALSE(entry.is_directory()) << "the files of LAMMPS are removed";
}

TEST(Cluster, that_fails_shows_the_message_of_lammps_and_keeps_its_files) {
    const TemporaryFolder folder;
    const Outcome failed =
        run_program({"cluster", "--model", "mesh", "--dt", "5", "--steps", "1000", "--ranks", "1", "--files", "kept"},
                    {.folder = folder.path()});
    EXPECT_EQ(failed.code, 4);
    EXPECT_THAT(failed.err, HasSubstr("ERROR"));
    EXPECT_THAT(failed.err, HasSubstr("is dt too large?"));
    EXPECT_THAT(failed.err, HasSubstr("are kept in 'kept'"));
    EXPECT_TRUE(std::filesystem::exists(folder.file("kept/log.lammps")));
}

// LAMMPS takes any energy for one; a run of steplab ends at the same step.
TEST(Cluster, that_diverges_is_said_to_have_as_a_run_of_steplab_is) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    const std::vector<std::string> chain{"--model", "chain", "--dt", "1.02", "--steps", "50", "--every", "1"};
    const Outcome there =
        steplab({"cluster", "--ranks", "1", "--out", "there.csv", "--summary", "there.json"}, chain, here);
    EXPECT_EQ(there.code, 4);
    EXPECT_THAT(there.err, HasSubstr("diverged in LAMMPS: its energy is"));
    EXPECT_THAT(there.err, HasSubstr("the files of LAMMPS are kept"));
    EXPECT_THAT(there.out, HasSubstr("diverged in step"));
    const Json summary = Json::parse(text_of(folder.file("there.json")));
    EXPECT_EQ(summary["status"], "diverged");
    const Outcome ours = steplab({"run", "--method", "velocity-verlet", "--summary", "ours.json"}, chain, here);
    EXPECT_EQ(ours.code, 4);
    const Json own = Json::parse(text_of(folder.file("ours.json")));
    EXPECT_EQ(summary["diverged_step"], own["diverged_step"]);
    const CsvTable rows = table(text_of(folder.file("there.csv")));
    const std::size_t particles = own["particles"].get<std::size_t>(), steps = own["steps"].get<std::size_t>();
    EXPECT_EQ(rows.rows.size(), (steps + 1) * particles) << "those before it";
}

// A fall exchanges far more energy than there was at the start.
TEST(Cluster, that_falls_far_has_not_diverged) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(
        {"cluster", "--model", "rope", "--dt", "0.002", "--steps", "1000", "--ranks", "1"}, {.folder = folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(Cluster, is_judged_by_what_it_had_at_the_start_and_the_work_of_outer_forces) {
    const RunDescription run = describe("oscillator", "velocity-verlet");
    const double start = 0.5;  // of mass 1 at a speed of 1
    const auto steps_of = [&](double gain, double outside) {
        const std::vector<LammpsEnergy> energies{{0, 0, start, 0}, {10, outside, start + gain - outside, outside}};
        return cluster_summary(run, 10, 2, energies, 1).result.steps;
    };
    EXPECT_EQ(steps_of(999 * start, 0), 10U);
    EXPECT_EQ(steps_of(1001 * start, 0), 9U);
    EXPECT_EQ(steps_of(1001 * start, 2 * start), 10U);
    EXPECT_EQ(steps_of(2999 * start, -2 * start), 10U);
    EXPECT_EQ(steps_of(3002 * start, -2 * start), 9U);
    EXPECT_EQ(steps_of(NAN, 0), 9U);
    EXPECT_EQ(cluster_summary(run, 10, 2, {{0, NAN, start, 0}}, 1).result.steps, 0U) << "from its start";
}

TEST(Cluster, without_lammps_or_mpirun_names_the_package) {
    const TemporaryFolder folder;
    put_program(folder, "lmp", "exit 0\n");
    const Outcome no_lammps =
        steplab({"cluster", "--ranks", "1"}, small_mesh, {.folder = folder.path(), .environment = {"PATH=/nowhere"}});
    EXPECT_EQ(no_lammps.code, 3);
    EXPECT_THAT(no_lammps.err, HasSubstr("no program lmp; on Debian and Ubuntu it is in the package lammps"));
    const Outcome no_mpi = steplab({"cluster", "--ranks", "2"}, small_mesh,
                                   {.folder = folder.path(), .environment = {"PATH=" + folder.path()}});
    EXPECT_EQ(no_mpi.code, 3);
    EXPECT_THAT(no_mpi.err, HasSubstr("mpirun"));
    EXPECT_THAT(no_mpi.err, HasSubstr("openmpi-bin"));
}

TEST(Cluster, of_another_program_than_lammps_says_so) {
    const TemporaryFolder folder;
    for (const char* const says : {"", "echo hello\n"}) {
        put_program(folder, "other", std::string(says) + "exit 0\n");
        for (const char* const command : {"cluster", "crosscheck"}) {
            const Outcome outcome =
                steplab({command, "--ranks", "1"}, small_mesh,
                        {.folder = folder.path(), .environment = {"LAMMPS=" + folder.file("other")}});
            EXPECT_EQ(outcome.code, 3);
            EXPECT_THAT(outcome.err, HasSubstr("no LAMMPS has run in '"));
            EXPECT_THAT(outcome.err, HasSubstr(*says ? "log.lammps: hello" : "log.lammps: it printed nothing"));
        }
    }
}

/// Of a process that has ended it may not have been asked yet how.
bool is_alive(int process) {
    std::string name, state;
    std::ifstream(fmt::format("/proc/{}/stat", process)) >> name >> name >> state;
    return !state.empty() && state != "Z";
}

// A program in LAMMPS' place that never ends by itself, and says what it has started.
TEST(Cluster, that_is_interrupted_ends_lammps_and_keeps_the_files) {
    const TemporaryFolder folder;
    put_program(folder, "lmp", "sleep 1000 &\necho $! >\"$STARTED\"\nwait\n");
    const Surroundings here{
        .folder = folder.path(),
        .environment = {"PATH=" + folder.path() + ":" + std::getenv("PATH"), "STARTED=" + folder.file("started")}};
    ASSERT_EQ(mkfifo(folder.file("started").c_str(), 0600), 0);
    RunningProgram program({"cluster", "--model", "chain", "--steps", "5", "--ranks", "1", "--files", "kept"}, here);
    const int lammps = std::stoi(text_of(folder.file("started")));  // waits until it runs
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, 128 + SIGINT);
    EXPECT_THAT(outcome.err, HasSubstr("are kept in 'kept'"));
    while (is_alive(lammps)) sched_yield();  // the signal is on its way
}

TEST(Cluster, writes_a_batch_file) {
    const TemporaryFolder folder;
    const Outcome outcome = steplab({"cluster", "--ranks", "256", "--submit", "slurm", "--files", "job"}, small_mesh,
                                    {.folder = folder.path()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("sbatch job/job.slurm"));
    const std::string batch = text_of(folder.file("job/job.slurm"));
    EXPECT_THAT(batch, StartsWith("#!/bin/bash\n"));
    EXPECT_THAT(batch, HasSubstr("#SBATCH --ntasks=256\n"));
    EXPECT_THAT(batch, HasSubstr("srun"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("job/log.lammps"))) << "nothing is computed";
}

TEST(Cluster, collects_the_results_of_a_batch_job) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    const std::vector<std::string> same{"--every", "20"};
    const auto call = [&](std::vector<std::string> words) {
        words.insert(words.end(), same.begin(), same.end());
        return steplab(std::move(words), small_mesh, here);
    };
    ASSERT_EQ(call({"cluster", "--ranks", "2", "--submit", "slurm", "--files", "job"}).code, 0);
    const std::vector<std::string> collect{"cluster", "--collect", "job", "--out", "a.csv", "--summary", "-"};
    const Outcome early = call(collect);
    EXPECT_EQ(early.code, 3) << early.err;
    EXPECT_THAT(early.err, HasSubstr("log.lammps"));
    ASSERT_EQ(std::system(("sh " + folder.file("job/run.sh") + " 2 >" + folder.file("job/screen.lammps")).c_str()), 0);
    const Outcome collected = call(collect);
    ASSERT_EQ(collected.code, 0) << collected.err;
    const Outcome direct = call({"cluster", "--ranks", "2", "--out", "b.csv", "--summary", "-"});
    EXPECT_EQ(text_of(folder.file("a.csv")), text_of(folder.file("b.csv")));
    Json theirs = Json::parse(direct.out), ours = Json::parse(collected.out);
    for (Json* const each : {&theirs, &ours}) each->erase("wall_seconds");
    EXPECT_EQ(ours, theirs);

    const Outcome other = run_program({"cluster", "--collect", "job", "--model", "mesh", "--steps", "51"}, here);
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.err, HasSubstr("those of another scene or time"));
    std::string log = text_of(folder.file("job/log.lammps"));
    put_text(folder.file("job/log.lammps"), log.substr(0, log.find("Loop time")));
    const Outcome cut = call(collect);
    EXPECT_EQ(cut.code, 4);
    EXPECT_THAT(cut.err, HasSubstr("has not gone all steps (step 50 of 50)"));
}

// A full disk or a job that was killed leaves such files.
TEST(Cluster, does_not_take_what_lacks_steps_for_a_whole_run) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    const std::vector<std::string> every{"cluster", "--every", "20"};
    const auto call = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = every;
        words.insert(words.end(), more.begin(), more.end());
        return steplab(words, small_mesh, here);
    };
    ASSERT_EQ(call({"--ranks", "1", "--files", "job"}).code, 0);
    const std::string dump = text_of(folder.file("job/trajectory.dump"));
    const std::string one = dump.substr(0, dump.find("ITEM: TIME", dump.find("ITEM: ATOMS")));
    for (const std::string& wrong : {one, one + one, dump + dump, std::string()}) {
        put_text(folder.file("job/trajectory.dump"), wrong);
        const Outcome outcome = call({"--collect", "job", "--out", "a.csv"});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("dump of LAMMPS"));
        EXPECT_FALSE(std::filesystem::exists(folder.file("a.csv")));
    }
    put_program(folder, "early", "lmp \"$@\" -var steps 10\nexit 0\n");
    const Outcome early = steplab({"cluster", "--ranks", "1", "--out", "b.csv"}, small_mesh,
                                  {.folder = folder.path(), .environment = {"LAMMPS=" + folder.file("early")}});
    EXPECT_EQ(early.code, 4);
    EXPECT_THAT(early.err, HasSubstr("LAMMPS has not gone all steps (step 10 of 50)"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("b.csv")));
    EXPECT_EQ(call({"--ranks", "101"}).code, 2) << "more than particles";
}

// Else they would be collected as those of the new scene.
TEST(Cluster, files_of_another_scene_do_not_come_beside_results) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    ASSERT_EQ(steplab({"cluster", "--ranks", "1", "--files", "job"}, small_mesh, here).code, 0);
    const std::string log = text_of(folder.file("job/log.lammps")), scene = text_of(folder.file("job/in.scene"));
    for (const std::vector<std::string>& again : {std::vector<std::string>{"export", "--to", "lammps", "--out", "job"},
                                                  {"cluster", "--ranks", "1", "--submit", "slurm", "--files", "job"}}) {
        const Outcome outcome = steplab(again, {"--model", "chain", "--steps", "9"}, here);
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("'job' holds the results of an earlier job (log.lammps)"));
        EXPECT_EQ(text_of(folder.file("job/log.lammps")), log);
        EXPECT_EQ(text_of(folder.file("job/in.scene")), scene);
    }
    const Outcome another =
        steplab({"cluster", "--ranks", "1", "--files", "job"}, {"--model", "chain", "--steps", "9"}, here);
    EXPECT_EQ(another.code, 0) << "it begins again: " << another.err;
}

TEST(Cluster, with_another_program_than_lmp_says_what_is_wrong_with_it) {
    const TemporaryFolder folder;
    put_program(folder, "silent", "exit 1\n");
    const auto message = [&](const std::string& program, int code) {
        const Outcome outcome = steplab({"cluster", "--ranks", "1"}, small_mesh,
                                        {.folder = folder.path(), .environment = {"LAMMPS=" + program}});
        EXPECT_EQ(outcome.code, code) << outcome.err;
        return outcome.err;
    };
    EXPECT_THAT(message("/nonexistent/lmp", 3), HasSubstr("LAMMPS=/nonexistent/lmp: there is no such program"));
    EXPECT_THAT(message("not-there", 3), HasSubstr("there is no such program"));
    EXPECT_THAT(message(folder.path(), 3), HasSubstr("there is no such program")) << "a folder";
    EXPECT_THAT(message(folder.file("silent"), 4), HasSubstr("LAMMPS ended before the last step: it printed nothing"));
}

TEST(Cluster, refuses_wrong_use) {
    const auto message = [](const std::vector<std::string>& words) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        return outcome.err;
    };
    EXPECT_THAT(message({"cluster", "--model", "chain"}), HasSubstr("--ranks is required"));
    EXPECT_THAT(message({"cluster", "--ranks", "0"}), HasSubstr("--ranks"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--method", "rk4"}), HasSubstr("does not have the method rk4"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--submit", "pbs", "--files", "x"}),
                HasSubstr("unknown batch system 'pbs'"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--submit", "slurm"}), HasSubstr("--files DIR"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--submit", "slurm", "--files", "x", "--out", "a.csv"}),
                HasSubstr("--collect DIR"));
    EXPECT_THAT(message({"convert", "x.csv", "--out", "x.png"}), HasSubstr(".dump, .pvd"));
    EXPECT_THAT(message({"convert", "x.csv", "--format", "vtk"}), HasSubstr("dump, pvd"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--collect", "x"}), HasSubstr("a job that has ended"));
    EXPECT_THAT(message({"cluster", "--ranks", "2", "--out", "x.png"}), HasSubstr("png"));
    EXPECT_THAT(message({"export", "--model", "chain", "--to", "lammps"}), HasSubstr("--out DIR"));
    EXPECT_THAT(message({"export", "--model", "chain", "--to", "scene", "--steps", "3"}),
                HasSubstr("--steps belongs to --to lammps"));
    EXPECT_THAT(message({"export", "--model", "chain", "--to", "lamps"}), HasSubstr("did you mean 'lammps'"));
    EXPECT_THAT(message({"crosscheck", "--model", "chain", "--precision", "float"}), HasSubstr("not in float"));
}

TEST(Crosscheck, prints_a_table_and_a_verdict) {
    const Outcome outcome =
        run_program({"crosscheck", "--model", "chain", "--steps", "50", "--samples", "5", "--ranks", "2"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("chain, 50 steps of dt 0.1, velocity Verlet here and in LAMMPS"));
    EXPECT_THAT(outcome.out, HasSubstr("steplab and LAMMPS agree within rounding."));
}

TEST(Export, to_xyz_writes_the_particles_as_a_run_begins_with_them) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    for (const std::string out : {"a.xyz", "a.xyz.gz"}) {
        ASSERT_EQ(run_program({"export", "--scene", "two-planets", "--to", "xyz", "--out", out}, here).code, 0);
        ASSERT_EQ(run_program({"run", "--scene", "two-planets", "--steps", "0", "--out", "run-" + out}, here).code, 0);
        EXPECT_EQ(text_of(folder.file(out)), text_of(folder.file("run-" + out)));
    }
    const Outcome wrong = run_program({"export", "--model", "chain", "--to", "xyz", "--steps", "3"}, here);
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("--steps belongs to --to lammps"));
}

TEST(Export, to_lammps_says_what_was_written_and_keeps_17_digits) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program({"export", "--model", "chain", "--set", "L=0.1", "--set",
                                         "v0=0.3333333333333333", "--to", "lammps", "--out", "job"},
                                        {.folder = folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("10 particles and 9 springs, for LAMMPS\n"));
    EXPECT_THAT(outcome.out, HasSubstr("job/run.sh RANKS"));
    const std::string data = text_of(folder.file("job/scene.data"));
    EXPECT_THAT(data, HasSubstr("\n4 1 2 0.30000000000000004 0 0\n"));
    EXPECT_THAT(data, HasSubstr("\n10 0.3333333333333333 0 0\n"));
    EXPECT_THAT(data, HasSubstr("\n1 bond types\n")) << "lengths that differ by rounding are one";
}

}  // namespace
}  // namespace steplab
