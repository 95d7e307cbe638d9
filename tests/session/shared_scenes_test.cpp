#include "session/shared_scenes.hpp"

#include "session/session_file.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

const std::string two_balls = "steplab = 1\n[parameters]\nspeed = 1\n[[particles]]\nvelocity = [\"speed\", 0, 0]\n";

/// The scene as it is read from a file each time, with a value and an altered particle.
RunDescription read_again(const std::string& text = two_balls, const std::string& name = "a.toml") {
    RunDescription run = describe(scene_from({{.name = "", .content = text}}, name));
    run.scene.set("speed", 3);
    const std::vector<Alteration> heavy{{.particle = 0, .mass = 5}};
    return with_alterations(std::move(run), heavy);
}

TEST(SharedScenes, equal_files_are_kept_once) {
    SharedScenes scenes;
    RunDescription first = read_again(), second = read_again();
    std::optional<RunDescription> as_read = second;
    const std::weak_ptr<const SceneFile> read = second.origin.watched();
    ASSERT_NE(&*first.origin, &*second.origin);
    scenes.share(first);
    scenes.share(second);
    EXPECT_EQ(&*first.origin, &*second.origin);
    EXPECT_EQ(second, *as_read);
    EXPECT_EQ(second.scene["speed"], 3);
    EXPECT_EQ(second.scene.infos().data(), first.origin->model->info.parameters.data());
    EXPECT_EQ(second.alterations.of(0).mass, 5);
    as_read.reset();
    EXPECT_TRUE(read.expired());
}

TEST(SharedScenes, others_are_not) {
    SharedScenes scenes;
    RunDescription first = read_again(), named = read_again(two_balls, "b.toml"), other = read_again(two_balls + "\n");
    for (RunDescription* const run : {&first, &named, &other}) scenes.share(*run);
    EXPECT_NE(&*first.origin, &*named.origin);
    EXPECT_NE(&*first.origin, &*other.origin);
    EXPECT_EQ(named.origin->given, "b.toml");
}

TEST(SharedScenes, are_not_kept_by_it) {
    SharedScenes scenes;
    std::optional<RunDescription> first = read_again();
    scenes.share(*first);
    const std::weak_ptr<const SceneFile> scene = first->origin.watched();
    first.reset();
    EXPECT_TRUE(scene.expired());
    RunDescription next = read_again();
    scenes.share(next);
    EXPECT_EQ(next, read_again());
}

TEST(SharedScenes, of_a_recording_are_those_of_all_its_events) {
    SharedScenes scenes;
    RunDescription shown = read_again();
    scenes.share(shown);
    Recording recording{.start = read_again()};
    for (const Event& event : {Event(event::Begin{read_again()}), Event(event::Change{read_again()}),
                               Event(event::AddRun{read_again()}), Event(event::ChangeRun{1, read_again()})})
        recording.events.push_back({event});
    const std::string text = session_text(recording);
    const auto in_use = shown.origin.watched().use_count();
    scenes.share(recording);
    EXPECT_EQ(shown.origin.watched().use_count(), in_use + 2 * 5) << "of each run and its alterations";
    EXPECT_EQ(session_text(recording), text);
}

}  // namespace
}  // namespace steplab::test
