#include "models/scene/planner.hpp"

#include "models/scene/scene_particles.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Its forces are described by equal numbers, and it starts at equal places.
void expect_equal_starts(const Plan& a, const Plan& b, const std::string& of) {
    ASSERT_EQ(a.start.count(), b.start.count()) << of;
    for (std::size_t i = 0; i < a.start.count(); ++i) {
        const Start::Particle one = a.start[i], other = b.start[i];
        EXPECT_EQ(a.reference.at(i) + one.displacement, b.reference.at(i) + other.displacement) << of << ' ' << i;
        EXPECT_EQ(one.velocity, other.velocity) << of << ' ' << i;
    }
}

TEST(Planner, recognises_every_model_in_its_value) {
    for (const Model& model : models()) {
        const ParameterValues values(model.info.parameters);
        const Plan direct = model.plan(values), found = planned(model.scene(values));
        const bool composed = model.info.id == "free";
        EXPECT_EQ(found.forces.index(), composed ? Forces(ComposedForces()).index() : direct.forces.index())
            << model.info.id;
        EXPECT_EQ(found.mass, direct.mass);
        EXPECT_EQ(found.drag, direct.drag);
        expect_equal_starts(found, direct, std::string(model.info.id));
    }
}

Scene chain_scene() { return model("chain").scene(describe("chain").scene); }

TEST(Planner, composes_what_is_a_little_different) {
    const auto index = [](const Scene& scene) { return planned(scene).forces.index(); };
    const std::size_t line = Forces(LineForces()).index(), composed = Forces(ComposedForces()).index();
    ASSERT_EQ(index(chain_scene()), line);
    Scene other = chain_scene();
    other.springs.front().quadratic = 0.1;
    EXPECT_EQ(index(other), composed);
    other = chain_scene();
    other.springs.front().length = 1.5;
    EXPECT_EQ(index(other), composed);
    other = chain_scene();
    other.springs.push_back({.pairs = {{"chain[0]", "chain[2]"}}, .k = 1});
    EXPECT_EQ(index(other), composed);
    other = chain_scene();
    other.fixes.push_back({.particles = {"chain[3]"}, .fixed = true});
    EXPECT_EQ(index(other), composed);
    other = chain_scene();
    other.fields.clear();
    other.fixes.push_back({.particles = {"chain[3]"}, .mass = WrittenNumber(2)});
    EXPECT_EQ(index(other), composed);
}

TEST(Planner, takes_springs_of_a_line_however_they_are_written) {
    Scene scene = chain_scene();
    scene.springs.clear();
    for (int i = 0; i < 9; ++i) {
        const std::string one = std::to_string(i), other = std::to_string(i + 1);
        scene.springs.push_back({.pairs = {{one, "chain[" + other + "]"}}, .k = 1, .length = WrittenNumber(2)});
    }
    EXPECT_EQ(planned(scene).forces.index(), Forces(LineForces()).index());
}

TEST(SceneParticles, are_named_by_group_index_and_place) {
    Scene scene;
    scene.particles = {{.group = "sun"},
                       {.group = "rope", .arrangement = LineArrangement{10, {1, 0, 0}}},
                       {.group = "cloth", .arrangement = GridArrangement{4, 3, {}}}};
    const SceneParticles particles(scene);
    const std::vector<std::pair<const char*, IndexRange>> cases{
        {"all", {0, 23}},         {"sun", {0, 1}},       {"rope", {1, 10}},     {"rope[0]", {1, 1}},
        {"rope[-1]", {10, 1}},    {"rope[2-5]", {3, 4}}, {"cloth[5]", {16, 1}}, {"cloth[3,2]", {22, 1}},
        {"cloth[-1,0]", {14, 1}}, {"7", {7, 1}},         {"4-9", {4, 6}},       {"-1", {22, 1}}};
    for (const auto& [text, range] : cases) EXPECT_EQ(particles.named(text), range) << text;
    const std::vector<std::pair<const char*, const char*>> wrong{
        {"roop", "did you mean 'rope'?"},       {"rope[10]", "from 0 to 9"},     {"rope[1,2]", "is no grid"},
        {"cloth[4,0]", "from 0 to 3"},          {"rope[x]", "a number belongs"}, {"rope[1", "closing bracket"},
        {"rope[5-2]", "ends before it begins"}, {"23", "from 0 to 22"}};
    for (const auto& [text, message] : wrong)
        EXPECT_THAT(([&particles, name = text] { particles.named(name); }),
                    ThrowsMessage<UsageError>(HasSubstr(message)))
            << text;
}

TEST(SceneParticles, are_what_the_last_fix_says) {
    Scene scene;
    scene.particles = {{.group = "rope", .arrangement = LineArrangement{10, {1, 0, 0}}}};
    scene.fixes = {{.particles = {"rope"}, .mass = WrittenNumber(2)},
                   {.particles = {"rope[3-6]"}, .mass = WrittenNumber(3)},
                   {.particles = {"rope[5]"}, .fixed = true, .velocity = WrittenVector{1, 0, 0}}};
    const SceneParticles particles(scene);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(particles[i].mass, i >= 3 && i <= 6 ? 3 : 2) << i;
    EXPECT_TRUE(particles[5].fixed);
    EXPECT_EQ(particles[5].velocity, Vec3{}) << "a fixed particle does not move";
    EXPECT_FALSE(particles[4].fixed || particles[6].fixed);
}

TEST(SceneParticles, of_an_exact_temperature_have_its_energy_and_no_momentum) {
    Scene scene;
    scene.particles = {{.mass = 3,
                        .arrangement = CrystalArrangement{CrystalArrangement::Kind::fcc, {3, 2, 2}, 1.5},
                        .temperature = Temperature{0.7, 5, true}}};
    const SceneParticles particles(scene);
    ASSERT_EQ(particles.count(), 48u);
    double energy = 0;
    Vec3 momentum;
    for (std::size_t i = 0; i < 48; ++i) {
        energy += 3 * dot(particles[i].velocity, particles[i].velocity);
        momentum = momentum + particles[i].velocity;
    }
    EXPECT_NEAR(energy, (3 * 48 - 3) * 0.7, 1e-10);  // rounding of 144 terms
    EXPECT_LT(length(momentum), 1e-13);
}

}  // namespace
}  // namespace steplab::test
