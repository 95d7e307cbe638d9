// Scenes that are too large, or of many blocks, and numbers that no float holds.
#include "core/error.hpp"
#include "models/scene/scene_particles.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"
#include "support/heap.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

template <class Work>
double seconds_of(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Whatever would go through its particles: a loop over two billion takes minutes, a name for each of them all memory.
TEST(SceneLimits, too_many_particles_are_refused_at_once_at_their_number) {
    const std::vector<std::pair<const char*, const char*>> counts{
        {"line = { count = 4294967295, step = [1, 0, 0] }", "a.toml:4:18: "},
        {"line = { step = [1, 0, 0], count = \"2e9\" }", "a.toml:4:36: "},
        {"grid = { count = [65535, 65535], steps = [[1, 0, 0], [0, 0, 1]] }", "a.toml:4:18: "},
        {"lattice = { kind = \"fcc\", cells = [1000, 1000, 1000] }", "a.toml:4:35: "}};
    const std::vector<const char*> rest{"",
                                        "temperature = { kT = 1 }\n",
                                        "displacement = { random = 1 }\n",
                                        "[[fields]]\npotential = \"x\"\n",
                                        "[[fields]]\ndrag = 1\n",
                                        "[[pairs]]\npotential = \"r\"\n",
                                        "[[pairs]]\npotential = \"gravity\"\nG = 1\ncutoff = 1\n",
                                        "[[fix]]\nparticles = \"all\"\nmass = 2\n",
                                        "[start]\nmode = 1\namplitude = 1\n"};
    for (const auto& [count, place] : counts) {
        for (const char* more : rest) {
            SCOPED_TRACE(std::string(count) + more);
            const double before = heap();
            std::string answer;
            const std::string text = std::string("steplab = 1\n[[particles]]\ngroup = \"a\"\n") + count + "\n" + more;
            // a hundred times what it takes; and of the memory nothing depends on the count
            EXPECT_LT(seconds_of([&] { answer = refusal_of_scene(text); }), 1);
            EXPECT_THAT(answer, AllOf(StartsWith(place), HasSubstr(" particles need "), HasSubstr("choose fewer")));
            EXPECT_LT(heap() - before, 1e8);
        }
    }
}

TEST(SceneLimits, too_many_particles_by_a_parameter_are_refused_as_its_value) {
    RunDescription run =
        describe(read_scene("steplab = 1\n[parameters]\nn = 3\n[[particles]]\ntemperature = { kT = 1 }\nline = { count "
                            "= \"n\", step = [1, 0, 0] }\n"));
    run.scene.set("n", 4e9);
    EXPECT_LT(seconds_of([&] {
                  try {
                      check(run);
                      ADD_FAILURE();
                  } catch (const UsageError& error) {
                      EXPECT_THAT(error.what(), StartsWith("a.toml:6:18: 4e9 particles need "));
                  }
              }),
              1);
}

// Each of them on all particles, or on a few: 100 000 on all of 1000 took a minute, of which 100 000 000 were the
// values of one field of a particle. Now they take what their text takes to read, about a second.
TEST(SceneLimits, many_fixes_cost_what_they_touch) {
    std::string text = "steplab = 1\n[[particles]]\nline = { count = 1000, step = [1, 0, 0] }\n";
    for (int i = 0; i < 100'000; ++i)
        text += fmt::format("[[fix]]\nparticles = \"{}\"\nmass = {}\n", i % 3 == 1 ? "all" : "10-12", 1 + i);
    double mass = 0, other = 0;
    EXPECT_LT(seconds_of([&] {
                  const RunDescription run = describe(read_scene(text));
                  check(run);
                  const Scene scene = model_of(run).scene(run.scene);
                  const SceneParticles particles(scene);
                  for (std::size_t i = 0; i < particles.count(); ++i) mass += particles[i].mass;
                  other = particles[11].mass;
              }),
              20);
    EXPECT_EQ(other, 100'000) << "the last on some";
    EXPECT_EQ(mass, 997 * 99'998.0 + 3 * 100'000.0) << "the last on all";
}

TEST(SceneLimits, many_groups_are_found_without_looking_through_all) {
    std::string text = "steplab = 1\n";
    constexpr int count = 20'000;  // squared 400 000 000 comparisons of names, some seconds
    for (int i = 0; i < count; ++i) text += fmt::format("[[particles]]\ngroup = \"particle-of-a-long-row-{}\"\n", i);
    text += "[[springs]]\nk = 1\npairs = [";
    for (int i = 1; i < count; ++i)
        text += fmt::format("[\"particle-of-a-long-row-{}\", \"particle-of-a-long-row-{}\"], ", i - 1, i);
    EXPECT_LT(seconds_of([&] { EXPECT_EQ(refusal_of_scene(text + "]\n"), "read"); }), 4);
}

std::string refusal_in(Precision precision, const std::string& text) {
    RunDescription run = describe(read_scene(text));
    run.precision = precision;
    try {
        check(run);
        return "taken";
    } catch (const UsageError& error) {
        return error.what();
    }
}

TEST(SceneLimits, numbers_that_no_float_holds_are_refused_in_float_alone) {
    const std::string begin = "steplab = 1\n[[particles]]\ngroup = \"a\"\nline = { count = 2, step = [1, 0, 0] }\n";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"mass = 1e-45", "a.toml:5:8: 1e-45 is lost in float"},
        {"mass = 1e39", "a.toml:5:8: 1e39 is lost in float"},
        {"mass = \"1e-20 * 1e-20\"", "a.toml:5:8: "},
        {"charge = 1e-40", "a.toml:5:10: "},
        {"position = [0, 1e40, 0]", "a.toml:5:16: "},
        {"position = [0, 1e-60, 0]", "taken"},
        {"velocity = [0, 1e-60, 0]", "taken"},
        {"charge = 0", "taken"},
        {"[[springs]]\nbetween = \"a\"\nk = 1e-50", "a.toml:7:5: "},
        {"[[springs]]\nbetween = \"a\"\nk = 1\ncubic = 1e300", "a.toml:8:9: "},
        {"[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1e-50\nsigma = 1", "a.toml:7:11: "},
        {"[[pairs]]\npotential = \"A / r\"\nA = 1e-50", "a.toml:7:5: "},
        {"[[fields]]\ngravity = [0, -1e39, 0]", "a.toml:6:15: "},
        {"[parameters]\nb = 1e20\nc = \"b * b\"\n[[fields]]\npotential = \"x / c\"", "a.toml:9:13: "},
        {"[[fix]]\nparticles = \"a[0]\"\nmass = 1e-45", "a.toml:7:8: "}};
    for (const auto& [block, message] : cases) {
        EXPECT_THAT(refusal_in(Precision::float_, begin + block + "\n"), StartsWith(message)) << block;
        EXPECT_EQ(refusal_in(Precision::double_, begin + block + "\n"), "taken") << block;
    }
}

}  // namespace
}  // namespace steplab::test
