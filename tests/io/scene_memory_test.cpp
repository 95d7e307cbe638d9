// What a run of a scene of one's own takes, which decides whether it is refused.

#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/simulation.hpp"
#include "support/heap.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab::test {
namespace {

/// 10976 particles in a crystal, with what the block and the file say besides.
std::string crystal(const std::string& of_particles, const std::string& rest) {
    return "[[particles]]\nlattice = { kind = \"fcc\", cells = [14, 14, 14], constant = 1.56 }\n" + of_particles + rest;
}

struct Scene {
    const char* what;
    std::string text;
};
const Scene scenes[] = {
    {"springs",
     "[[particles]]\ngroup = \"c\"\ngrid = { count = [100, 100], steps = [[1, 0, 0], [0, 0, -1]] }\n"
     "[[springs]]\nbetween = \"c\"\nalong = \"both\"\nk = 1\n"},
    {"clusters", crystal("",
                         "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\ncutoff = 2.5\n"
                         "[box]\nsize = [21.84, 21.84, 21.84]\n")},
    {"neighbours in a slab", crystal("",
                                     "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\ncutoff = 2.5\n"
                                     "[box]\nsize = [21.84, 21.84, 0]\n")},
    {"neighbours with charges", crystal("charge = 1\n",
                                        "[[pairs]]\npotential = \"coulomb\"\nK = 1\ncutoff = 2.5\n"
                                        "[box]\nsize = [21.84, 21.84, 21.84]\n")},
    {"all pairs", crystal("", "[[pairs]]\npotential = \"gravity\"\nG = 1\nsoftening = 0.1\n")},
    {"fields", crystal("", "[[fields]]\npotential = \"x^4/4 - x^2/2\"\ndrag = 0.1\n")},
};

/// Never less than is taken, so that what is refused before it is allocated would not have fitted; nor more than twice
/// as much: a scene that takes half of the memory runs.
void expect_estimate_holds(const RunDescription& run) {
    const double estimated = bytes_of_run(run), before = heap();
    Simulation simulation(run);
    simulation.advance(1);
    const Frame frame = simulation.frame();
    const double taken = heap() - before;
    EXPECT_LE(taken, estimated);
    EXPECT_GE(taken, before > 0 ? estimated / 2 : 0);
}

TEST(SceneMemory, estimated_is_what_a_run_takes) {
    for (const Scene& scene : scenes) {
        const RunDescription run =
            describe(scene_from({{.name = "", .content = "steplab = 1\n" + scene.text}}, "a.toml"));
        for (const char* const method : {"velocity-verlet", "rk4", "dop853", "gauss-16"}) {
            SCOPED_TRACE(fmt::format("{} by {}", scene.what, method));
            // each evaluation of all pairs takes a second in lanes of stages
            if (std::string(scene.what) == "all pairs" && std::string(method) != "velocity-verlet") continue;
            RunDescription chosen = with_method(run, method);
            chosen.dt = 1e-4;
            expect_estimate_holds(chosen);
        }
    }
}

/// A cube of so many particles along each axis, each bound to those beside it.
std::string bound_cube(std::size_t side) {
    std::string text = fmt::format(
        "[[particles]]\nlattice = {{ kind = \"cubic\", cells = [{0}, {0}, {0}], constant = 1 }}\n[[springs]]\nk = 1\n"
        "cubic = 0.1\npairs = [",
        side);
    for (std::size_t x = 0; x < side; ++x) {
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t z = 0; z < side; ++z) {
                const std::size_t here = (x * side + y) * side + z;
                if (x + 1 < side) text += fmt::format("[{}, {}], ", here, here + side * side);
                if (y + 1 < side) text += fmt::format("[{}, {}], ", here, here + side);
                if (z + 1 < side) text += fmt::format("[{}, {}], ", here, here + 1);
            }
        }
    }
    return text + "]\n";
}

// What a factor of the matrix of Newton's method holds is counted for springs of any network. Of a triangle of all
// particles, as it would be without, a cloth of 2500 fills a fiftieth.
TEST(SceneMemory, estimated_for_linear_solvers_is_what_springs_take) {
    const std::string cloth =
        "[[particles]]\ngroup = \"c\"\ngrid = { count = [50, 50], steps = [[1, 0, 0], [0, 0, -1]] }\n"
        "[[springs]]\nbetween = \"c\"\nalong = \"both\"\nk = 1\ncubic = 0.1\n";
    for (const std::string& text : {cloth, bound_cube(9)}) {
        const RunDescription run = describe(scene_from({{.name = "", .content = "steplab = 1\n" + text}}, "a.toml"));
        for (const char* const method : {"implicit-midpoint", "tr-bdf2"}) {
            SCOPED_TRACE(method);
            const RunDescription chosen = with_method(run, method);
            const double estimated = bytes_of_run(chosen), before = heap();
            Simulation simulation(chosen);
            simulation.advance(1);
            const double taken = heap() - before;
            EXPECT_LE(taken, estimated);
            EXPECT_GE(taken, before > 0 ? estimated / 4 : 0);
        }
    }
}

// A cut-off leaves most pairs out: of 10976 particles each has 69 within 2.5 at 1.05 particles per unit of volume,
// which a count in cells gives to a fifth.
TEST(SceneMemory, pairs_beyond_the_cut_off_are_not_counted) {
    const RunDescription run =
        describe(scene_from({{.name = "", .content = "steplab = 1\n" + scenes[1].text}}, "a.toml"));
    const double partners = 2 * interacting_pairs(model_of(run).plan(run.scene)) / 10976;
    EXPECT_NEAR(partners, 1.0537 * 4.18879 * 2.5 * 2.5 * 2.5, 0.2 * 69);
}

}  // namespace
}  // namespace steplab::test
