// Scenes handed over to LAMMPS: energy and forces at the start are those of steplab, for every shipped scene and model.

#include "io/lammps/lammps_export.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/lammps/lammps_dump.hpp"
#include "io/lammps/lammps_run.hpp"
#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

void replace_in(const std::string& file, const std::string& text, const std::string& other) {
    std::string content = text_of(file);
    const std::size_t at = content.find(text);
    ASSERT_NE(at, std::string::npos) << text;
    put_text(file, content.replace(at, text.size(), other));
}

/// The start of a scene in LAMMPS.
struct LammpsStart {
    LammpsExport written;
    LammpsEnergy energy;
    LammpsMoment moment;
};

/// `alter` may change the files before LAMMPS reads them.
LammpsStart started_in_lammps(const RunDescription& run, const std::function<void(const std::string&)>& alter) {
    const TemporaryFolder folder;
    LammpsStart start{.written = export_to_lammps(run, {.steps = 0}, folder.path()), .energy = {}, .moment = {}};
    replace_in(folder.file(lammps_files::input), "vx vy vz\n", "vx vy vz fx fy fz\n");
    if (alter) alter(folder.path());
    LammpsRun lammps(folder.path(), 1);
    lammps.finish();
    start.energy = lammps.output().energies().front();
    LammpsDump dump(folder.file(lammps_files::trajectory), start.written.particles);
    EXPECT_TRUE(dump.next(start.moment));
    return start;
}

/// The largest differences at the start, in parts of the largest values.
struct Differences {
    double energy = 0, force = 0, position = 0, velocity = 0;
    double allowed = 0;  ///< rounding, or the stated error of tables
};

double largest(const std::vector<Vec3>& vectors) {
    double most = 0;
    for (const Vec3 v : vectors) most = std::max(most, length(v));
    return most;
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

Differences differences(const RunDescription& run, const std::function<void(const std::string&)>& alter = {}) {
    const LammpsStart start = started_in_lammps(run, alter);
    const Simulation simulation(run);
    const Frame frame = simulation.frame();
    std::vector<Vec3> forces, theirs = start.moment.forces;
    simulation.forces(forces);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        if (frame.shape->roles[i] == Role::fixed) forces[i] = theirs[i] = {};
    }
    const Diagnostics now = simulation.diagnostics();
    Differences found;
    const double size = largest(frame.positions), pull = std::max(largest(forces), 1e-3);
    found.position = apart(frame.positions, start.moment.positions) / std::max(size, 1.0);
    found.velocity = apart(frame.velocities, start.moment.velocities);
    found.force = apart(forces, theirs) / pull;
    const double energy = std::max(std::abs(now.kinetic) + std::abs(now.energy), 1.0);
    found.energy = std::abs(start.energy.total() - now.energy) / energy;
    // Positions of some hundred units are rounded to 1e-14 of a unit, and forces of springs of 1e5 N/m follow them.
    const double by_table = start.written.table_error * std::max(1.0, start.written.neighbour_force / pull);
    found.allowed = std::max(1e-9, 3 * by_table);  // two or three neighbours
    return found;
}

void expect_agreement(const RunDescription& run) {
    const Differences found = differences(run);
    EXPECT_EQ(found.position, 0);
    EXPECT_EQ(found.velocity, 0);
    EXPECT_LE(found.force, found.allowed);
    EXPECT_LE(found.energy, found.allowed);
}

class ExportedScene : public testing::TestWithParam<std::string> {};

TEST_P(ExportedScene, has_the_energy_and_the_forces_of_steplab) { expect_agreement(describe(find_scene(GetParam()))); }

// Both kinds of springs beside each other, a potential that depends on masses among them.
TEST(LammpsExport, has_springs_of_every_kind_in_one_scene) {
    const std::string text =
        "steplab = 1\n[[particles]]\ngroup = \"row\"\nline = { count = 5, step = [1, 0.2, 0] }\n"
        "[[fix]]\nparticles = \"row[2]\"\nmass = 3\n[[fix]]\nparticles = \"row[0]\"\nfixed = true\n"
        "[[springs]]\npairs = [[\"row[0]\", \"row[1]\"]]\nk = 4\nlength = 0.8\n"
        "[[springs]]\npairs = [[\"row[1]\", \"row[2]\"], [\"row[3]\", \"row[2]\"]]\n"
        "potential = \"m1*(exp(1 - r) + r)\"\n"
        "[[springs]]\npairs = [[\"row[3]\", \"row[4]\"]]\npotential = \"morse\"\nD = 2\nk = 9\nr0 = 0.9\n";
    const RunDescription run = describe(read_scene(text));
    expect_agreement(run);
    const Differences wrong =
        differences(run, [](const std::string& folder) { replace_in(folder + "/in.scene", "BOND_2", "BOND_3"); });
    EXPECT_GT(wrong.force, 100 * wrong.allowed);
}

// A force that grows without bound at 1.5 m: as accurate as others up to near there.
TEST(LammpsExport, of_springs_that_cannot_break_is_accurate) {
    const TemporaryFolder folder;
    const LammpsExport written = export_to_lammps(describe(find_scene("polymer")), {.steps = 0}, folder.path());
    EXPECT_LT(written.table_error, 1e-7);
    EXPECT_THAT(text_of(folder.file(lammps_files::bond_tables)), testing::Not(HasSubstr("nan")));
}

// LAMMPS has an array of the bins by which it sorts particles, over all of the box: of a mesh of 10^7 particles with
// bins as long as a spring there were more than it can count.
TEST(LammpsExport, of_a_plane_sorts_its_particles_into_few_bins) {
    RunDescription run = describe("mesh");
    run.scene.set("dim", 200);
    const TemporaryFolder folder;
    export_to_lammps(run, {.steps = 0}, folder.path());
    const std::string input = text_of(folder.file(lammps_files::input)), key = "atom_modify sort 1000 ";
    const std::size_t at = input.find(key);
    ASSERT_NE(at, std::string::npos);
    const double bin = std::stod(input.substr(at + key.size())), length = run.scene["L"] * 199;
    const double volume = length * length * 1.3 * 1.3 * length * 0.2 * std::sqrt(2.0);
    EXPECT_LT(volume / (bin * bin * bin), 3 * 200 * 200);
    EXPECT_GT(bin, run.scene["L"]);
}

std::string with_underscores(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Lammps, ExportedScene, testing::ValuesIn(shipped_scenes()),
                         [](const auto& scene) { return with_underscores(scene.param); });

class ExportedModel : public testing::TestWithParam<std::string> {};

TEST_P(ExportedModel, has_the_energy_and_the_forces_of_steplab) { expect_agreement(describe(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Lammps, ExportedModel, testing::ValuesIn(model_ids()),
                         [](const auto& model) { return with_underscores(model.param); });

RunDescription described(const std::string& terms) {
    const TemporaryFolder folder;
    put_text(folder.file("scene.toml"), "steplab = 1\n" + terms);
    return describe(find_scene(folder.file("scene.toml")));
}

const std::string three_particles = R"(
[[particles]]
group = "a"
position = [0.1, 0.2, 0]
line = { count = 3, step = [1.1, 0.1, 0.3] }
mass = 2
charge = 0.7
velocity = [0, 0.1, 0.2]
)";
const std::string two_more = R"(
[[particles]]
group = "b"
position = [0.3, 1.7, 0.4]
line = { count = 2, step = [1.3, 0, 0.2] }
mass = 0.5
charge = -1.3
)";

class ExportedTerms : public testing::TestWithParam<const char*> {};

TEST_P(ExportedTerms, have_the_energy_and_the_forces_of_steplab) {
    expect_agreement(described(three_particles + two_more + GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Lammps, ExportedTerms,
    testing::Values(  //
        "[[springs]]\nbetween = \"a\"\nk = 3\nlength = 0.9\nquadratic = 0.4\ncubic = 1.7\n"
        "[[springs]]\npairs = [[\"b[0]\", \"a[1]\"]]\nk = 2\nlength = 0\n",
        "[[pairs]]\nbetween = [\"a\", \"b\"]\npotential = \"coulomb\"\nK = 2.5\n"
        "[[pairs]]\nbetween = \"a\"\npotential = \"coulomb\"\nK = 2.5\n",
        "[[pairs]]\npotential = \"coulomb\"\nK = -1.5\n[[pairs]]\npotential = \"coulomb\"\nK = 1\nsoftening = 0.3\n",
        "[[pairs]]\npotential = \"gravity\"\nG = 1.5\ncutoff = 3\n[[pairs]]\npotential = \"morse\"\nD = 1\nk = 4\nr0 = "
        "1\ncutoff = 2.5\n",
        "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 0.7\nsigma = 0.8\n"
        "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 0.2\nsigma = 1.1\ncutoff = 2\n",
        "[[pairs]]\nbetween = [\"b\", \"a\"]\npotential = \"q1*q2*m1*exp(-r/0.5)/r\"\ncutoff = 4\n",
        "[[fields]]\nparticles = [\"a\"]\ngravity = [0.3, -9.81, 0.1]\ndrag = 0.4\n[[fields]]\ndrag = 0.2\n"
        "gravity = [0, 0, 1]\n[[fix]]\nparticles = [\"b[0]\"]\nfixed = true\n",
        "[[fields]]\nparticles = [\"a\"]\npotential = \"m*sin(x)*exp(y/3) + tanh(z) - max(x, y)^3 + sqrt(2 + x)/(1 + "
        "z^2)\"\n",
        "[box]\nsize = [8, 0, 9]\n[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\ncutoff = 2.5\n"
        "[[springs]]\npairs = [[\"a[0]\", \"a[2]\"]]\nk = 2\n"));

// The partner of all of the above: a constant that is off by a millionth is seen.
TEST(LammpsExport, with_another_force_constant_has_other_forces) {
    const auto alter = [](const std::string& folder) {
        replace_in(folder + "/scene.data", "\n1 100 0.5\n", "\n1 100.0001 0.5\n");
    };
    const RunDescription rope = described(R"(
[[particles]]
group = "rope"
line = { count = 3, step = [0.7, 0, 0] }
[[springs]]
between = "rope"
k = 200
length = 0.5
)");
    const Differences right = differences(rope), wrong = differences(rope, alter);
    EXPECT_LE(right.force, 1e-12);
    EXPECT_GT(wrong.force, 5e-7);
    EXPECT_GT(wrong.energy, 5e-7);
}

TEST(LammpsExport, with_another_velocity_has_another_energy) {
    const auto alter = [](const std::string& folder) {
        replace_in(folder + "/scene.data", "\n10 2 0 0\n", "\n10 2.1 0 0\n");
    };
    const Differences wrong = differences(describe("chain"), alter);
    EXPECT_GT(wrong.velocity, 0.09);
    EXPECT_GT(wrong.energy, 0.05);
}

std::string refusal_of(const RunDescription& run) {
    const TemporaryFolder folder;
    try {
        export_to_lammps(run, {.steps = 1}, folder.path());
    } catch (const UsageError& error) {
        EXPECT_TRUE(folder.empty()) << "nothing is written";
        return error.what();
    }
    return "";
}

TEST(LammpsExport, refuses_by_name_what_lammps_does_not_have) {
    const auto refusal = [](const std::string& terms) {
        return refusal_of(described(three_particles + two_more + terms));
    };
    EXPECT_EQ(refusal(""), "");
    EXPECT_THAT(refusal("[[springs]]\nbetween = \"a\"\nk = 1\ndamping = 0.1\n"), HasSubstr("dashpot"));
    EXPECT_THAT(refusal("[[pairs]]\nbetween = [\"all\", \"b\"]\npotential = \"gravity\"\nG = 1\n"),
                HasSubstr("two groups that have particles in common"));
    EXPECT_THAT(refusal("[[fields]]\npotential = \"q*x\"\n"), HasSubstr("on charges"));
    EXPECT_THAT(refusal("[box]\nsize = [9, 9, 9]\n[[fields]]\npotential = \"x^2\"\n"), HasSubstr("periodic box"));
    RunDescription run = describe("chain");
    run.precision = Precision::float_;
    EXPECT_THAT(refusal_of(run), HasSubstr("not in float"));
    run = describe("chain");
    run.dt = -0.1;
    EXPECT_THAT(refusal_of(run), HasSubstr("no negative time step"));
    run = describe("free");
    set_parameter(run, "n", "200");
    EXPECT_THAT(refusal_of(run), HasSubstr("different accelerations"));
}

TEST(LammpsExport, names_the_accuracy_of_tables_and_what_is_different_there) {
    const TemporaryFolder folder;
    const auto notes_of = [&](const RunDescription& run) { return export_to_lammps(run, {.steps = 1}, folder.path()); };
    const LammpsExport galaxies = notes_of(describe(find_scene("galaxies")));
    EXPECT_GT(galaxies.table_error, 0);
    EXPECT_LT(galaxies.table_error, 1e-6);
    EXPECT_GT(galaxies.reach, 100);
    EXPECT_THAT(notes_of(describe("rope")).notes,
                testing::ElementsAre(HasSubstr("not by rk4"), HasSubstr("fix viscous")));
    EXPECT_THAT(notes_of(describe("chain", "velocity-verlet")).notes, testing::IsEmpty());
}

}  // namespace
}  // namespace steplab::test
