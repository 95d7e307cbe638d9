// The same scenes by LAMMPS: an independent program as the judge of steplab's physics.

#include "lab/crosscheck/crosscheck.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/scene_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using Verdict = Crosscheck::Verdict;

struct Case {
    const char* name;
    RunDescription run;
    Verdict verdict;
};
void PrintTo(const Case& of, std::ostream* out) { *out << of.name; }

RunDescription crosschecked(const char* id, double dt, const std::vector<std::array<const char*, 2>>& settings = {}) {
    RunDescription run = describe(id);
    run.dt = dt;
    for (const auto& [name, value] : settings) set_parameter(run, name, value);
    return run;
}

std::vector<Case> cases() {
    return {{"chain", crosschecked("chain", 0.1), Verdict::rounding},
            {"mesh", crosschecked("mesh", 0.1), Verdict::rounding},
            {"rope_without_drag", crosschecked("rope", 0.01, {{"c", "0"}}), Verdict::rounding},
            {"rope_with_drag", crosschecked("rope", 0.01), Verdict::drag},
            {"morse", crosschecked("morse", 0.01), Verdict::rounding},
            {"crystal", crosschecked("crystal", 0.01), Verdict::rounding},
            {"lennard_jones", describe(find_scene("fcc-crystal")), Verdict::rounding},
            {"random_network", describe(find_scene("spring-network")), Verdict::rounding}};
}

/// Of particles that move all masses are equal; its forces are tables in LAMMPS.
constexpr const char* held_by_another_mass =
    "steplab = 1\n[[particles]]\nmass = 5\nfixed = true\n[[particles]]\nposition = [1, 0, 0]\n[[particles]]\n"
    "position = [0, 1.1, 0]\n[[pairs]]\npotential = \"(r - 1)^2 * exp(-r)\"\ncutoff = 3\n"
    "[run]\nmethod = \"velocity-verlet\"\ndt = 0.01\n";

Crosscheck checked(const RunDescription& run, std::uint64_t ranks,
                   const std::function<void(const std::string&)>& exported = {}) {
    const TemporaryFolder folder;
    return crosscheck(
        run,
        {.steps = 200, .samples = 10, .ranks = ranks, .folder = folder.path(), .exported = exported, .progress = {}});
}

/// Multiplies the masses in the files.
std::function<void(const std::string&)> masses_times(double factor) {
    return [factor](const std::string& folder) {
        const std::string file = folder + '/' + lammps_files::data, content = text_of(file), head = "\nMasses\n\n";
        const std::size_t from = content.find(head) + head.size(), to = content.find("\n\n", from);
        std::istringstream masses(content.substr(from, to - from));
        std::string altered = content.substr(0, from);
        double mass = 0;
        for (int type = 0; masses >> type >> mass;) altered += fmt::format("{} {}\n", type, mass * factor);
        put_text(file, altered + content.substr(to));
    };
}

TEST(Crosscheck, takes_a_fixed_particle_of_another_mass) {
    const Crosscheck check =
        checked(describe(scene_from({{.name = "", .content = held_by_another_mass}}, "a.toml")), 1);
    EXPECT_TRUE(check.agrees()) << check.verdict_text();
}

class CrosscheckOf : public testing::TestWithParam<Case> {};

TEST_P(CrosscheckOf, agrees_on_one_rank_and_on_two) {
    for (const std::uint64_t ranks : {1U, 2U}) {
        const Crosscheck check = checked(GetParam().run, ranks);
        EXPECT_EQ(check.verdict, GetParam().verdict) << ranks << " ranks: " << check.verdict_text();
        EXPECT_TRUE(check.agrees());
        EXPECT_EQ(check.moments.size(), 11U);
        EXPECT_EQ(check.moments.front().position, 0);
        EXPECT_EQ(check.moments.back().step, 200U);
    }
}

// A millionth is far above rounding; beside the error of LAMMPS' drag it takes a tenth.
TEST_P(CrosscheckOf, does_not_agree_with_another_mass) {
    const bool drag = GetParam().verdict == Verdict::drag;
    const Crosscheck check = checked(GetParam().run, 1, masses_times(drag ? 1.1 : 1 + 1e-6));
    EXPECT_EQ(check.verdict, Verdict::different) << check.verdict_text();
    EXPECT_THAT(check.verdict_text(), HasSubstr("do not agree"));
}

INSTANTIATE_TEST_SUITE_P(Lammps, CrosscheckOf, testing::ValuesIn(cases()),
                         [](const auto& scene) { return std::string(scene.param.name); });

// A bullet shot at a cube of Morse particles: after its first passage neighbouring motions diverge exponentially.
TEST(LammpsCrosscheck, says_where_rounding_hides_the_rest) {
    const TemporaryFolder folder;
    const Crosscheck check =
        crosscheck(crosschecked("morse", 0.01),
                   {.steps = 3000, .samples = 30, .ranks = 1, .folder = folder.path(), .exported = {}, .progress = {}});
    EXPECT_EQ(check.verdict, Verdict::sensitive) << check.verdict_text();
    EXPECT_GT(check.decided, 1U);
    EXPECT_LT(check.decided, check.moments.size());
    EXPECT_GT(check.exponent(), 0);
    EXPECT_THAT(check.verdict_text(), HasSubstr("up to t = "));
}

TEST(LammpsCrosscheck, shows_what_lammps_says_where_it_fails) {
    const TemporaryFolder folder;
    const auto spoil = [](const std::string& in) {
        put_text(in + '/' + lammps_files::input, "units lj\nnonsense 1 2\n");
    };
    try {
        crosscheck(describe("chain"),
                   {.steps = 10, .samples = 2, .ranks = 1, .folder = folder.path(), .exported = spoil, .progress = {}});
        FAIL() << "it has to fail";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("ERROR: Unknown command: nonsense 1 2"));
        EXPECT_EQ(error.code(), ExitCode::diverged);
    }
}

}  // namespace
}  // namespace steplab::test
