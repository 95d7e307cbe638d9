#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

TEST(FallingScene, has_an_exact_solution_that_methods_of_own_steps_follow) {
    const SceneOrigin scene = read_scene(R"(steplab = 1
[[particles]]
group = "throw"
velocity = [3, 4, 0]
[[fields]]
gravity = [0, -9.81, 0]
drag = 0.3
)");
    for (const char* const method : {"dopri5", "taylor", "gauss-16"}) {
        RunDescription run = with_method(describe(scene), method);
        run.dt = 0.1;
        Simulation simulation(run);
        ASSERT_TRUE(simulation.has_exact()) << method;
        simulation.advance(20);
        EXPECT_LT(*simulation.diagnostics().error, 1e-8) << method;  // ten of its tolerances
    }
}

}  // namespace
}  // namespace steplab::test
