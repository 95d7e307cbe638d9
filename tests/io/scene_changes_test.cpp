// Scene files that were cut or changed anywhere, and models as files.

#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/asked.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A shipped scene of which the file itself has another text: "read", or why it is refused.
std::string result_of(const std::string& name, const std::string& text) {
    std::vector<SceneFile::Part> parts = find_scene(name)->parts;
    parts.front().content = text;
    try {
        scene_from(std::move(parts), "a.toml");
        return "read";
    } catch (const FileError& error) {
        return error.what();
    }
}

std::string text_of_scene(const std::string& name) { return find_scene(name)->parts.front().content; }

bool is_answered(const std::string& result) { return result == "read" || result.starts_with("a.toml"); }

// Every shipped one, at every byte; those of many particles at every seventh.
TEST(SceneChanges, a_file_that_is_cut_anywhere_is_read_or_refused) {
    for (const std::string& name : shipped_scenes()) {
        const std::string text = text_of_scene(name);
        std::size_t refused = 0;
        const RunDescription run = describe(find_scene(name));
        const std::size_t stride = model_of(run).particles(run.scene) > 100 ? 7 : 1;  // to read those takes a moment
        for (std::size_t length = 0; length < text.size(); length += stride) {
            const std::string result = result_of(name, text.substr(0, length));
            EXPECT_TRUE(is_answered(result)) << name << ", " << length << " bytes: " << result;
            refused += result != "read";
        }
        EXPECT_GT(refused, text.size() / stride / 10) << name << ": much of what was cut is no scene";
        EXPECT_EQ(result_of(name, text), "read") << name;
    }
}

TEST(SceneChanges, a_file_that_is_changed_anywhere_is_read_or_refused) {
    constexpr int changes = 10000;
    const std::vector<std::string> names = shipped_scenes();
    std::vector<std::string> texts;
    for (const std::string& name : names) texts.push_back(text_of_scene(name));
    std::mt19937 random(2008);
    const std::string pieces = "0123456789.-[]{}\"'=#\n kngrope*/^()e";
    int refused = 0;
    for (int change = 0; change < changes; ++change) {
        const std::size_t scene = random() % names.size();
        std::string text = texts[scene];
        for (unsigned i = 0; i <= random() % 3; ++i) text[random() % text.size()] = pieces[random() % pieces.size()];
        const std::string result = result_of(names[scene], text);
        EXPECT_TRUE(is_answered(result)) << text << result;
        refused += result != "read";
    }
    EXPECT_GT(refused, changes / 10);
    EXPECT_LT(refused, changes - changes / 10);
}

std::string times(std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

// The library that parses TOML reads the parts of a key recursively.
TEST(SceneChanges, keys_of_many_parts_are_refused_wherever_they_stand) {
    for (const std::size_t parts : {101U, 1000U, 100'000U, 1'000'000U}) {
        const std::string key = times(parts - 1, "a.") + "a";
        for (const std::string& text :
             {key + " = 1\n", "[" + key + "]\n", "[[" + key + "]]\n", "[parameters]\n" + key + " = 1\n",
              "[[particles]]\nmass = { " + key + " = 1 }\n", "x = [{ " + key + " = 1 }]\n"}) {
            const std::string refusal = refusal_of_scene("steplab = 1\n" + text);
            EXPECT_THAT(refusal, HasSubstr("a key has at most 100 parts")) << parts << text.substr(0, 20);
            EXPECT_THAT(refusal, StartsWith("a.toml:")) << text.substr(0, 20);
        }
    }
    EXPECT_THAT(refusal_of_scene("steplab = 1\n" + times(99, "a.") + "a = 1\n"), Not(HasSubstr("parts")));
}

TEST(SceneChanges, lines_within_texts_count) {
    const std::string key = times(100, "a.") + "a = 1\n";
    for (const char* const text : {"\"\"\"one\ntwo\\\n three\"\"\"\n", "'''one\n\\\n'''\n", "\"\"\"\n\\\\\n\"\"\"\n"})
        EXPECT_THAT(refusal_of_scene("steplab = 1\ntitle = " + std::string(text) + key), StartsWith("a.toml:5:"));
}

TEST(SceneChanges, points_in_texts_and_comments_are_no_parts_of_keys) {
    const std::string points = times(500, ".");
    const std::string text = row_between_walls(3);
    for (const std::string& said : {"title = \"" + points + "\"\n", "title = '" + points + "'\n", "# " + points + "\n",
                                    "title = \"\"\"\n" + points + " \\\"\"\" " + points + "\"\"\"\n",
                                    "title = \"\\\"" + points + "\" # \" " + points + "\n"}) {
        EXPECT_EQ(refusal_of_scene("steplab = 1\n" + said + text.substr(text.find('\n') + 1)), "read") << said;
    }
}

TEST(SceneChanges, more_values_than_can_be_read_in_a_moment_are_refused) {
    EXPECT_THAT(refusal_of_scene("steplab = 1\nx = [" + times(4'000'001, "1,") + "1]\n"),
                StartsWith("a.toml:2:8000003: there are more than 4000000 values"));
    std::string parameters = "steplab = 1\n[parameters]\n";
    for (int i = 0; i < 1001; ++i) parameters += "p" + std::to_string(i) + " = 1\n";
    EXPECT_THAT(refusal_of_scene(parameters), StartsWith("a.toml:2:1: a scene has at most 1000 parameters"));
}

TEST(SceneChanges, messages_are_short_whatever_the_names) {
    const std::string name = times(50'000, "p");
    const std::string begin = "steplab = 1\n[parameters]\n" + name + " = ", end = "\n[[particles]]\n";
    for (const std::string& value :
         {std::string("1"), "\"" + name + "\"", std::string("{ unit = \"m\" }"),
          std::string("{ value = 1, range = [2, 1] }"),
          std::string("{ value = 1, range = [0, 1], logarithmic = true }"),
          std::string("{ value = -1, logarithmic = true }"), std::string("{ vlue = 1 }"), std::string("[1]")}) {
        const std::string refusal = refusal_of_scene(begin + value + end);
        EXPECT_NE(refusal, "read");
        EXPECT_LT(refusal.size(), 400) << value.substr(0, 40) << ": " << refusal.substr(0, 200);
    }
}

TEST(SceneChanges, parameters_have_no_names_that_runs_have) {
    for (const std::string name : {"dt", "method", "precision"}) {
        const std::string text =
            "steplab = 1\n[parameters]\n" + name + " = 2\n[[particles]]\nmass = \"" + name + "\"\n";
        EXPECT_THAT(refusal_of_scene(text), HasSubstr("every run has a '" + name + "' of its own")) << name;
        EXPECT_EQ(refusal_of_scene(replaced(replaced(text, name, name + "2"), "\"" + name, "\"" + name + "2")), "read");
    }
}

/// A run of a model and the same of the file that it is exported to.
struct Exported {
    RunDescription model, file;

    Exported(const Model& of, const Method& method, Precision precision)
        : model(describe(of.info.id, method.info.id)), file(model) {
        model.precision = precision;
        model.dt = 0.03;
        file = describe(read_scene(scene_file_text(model)));
    }
};

TEST(SceneChanges, models_exported_have_their_hashes_with_every_method) {
    std::size_t compared = 0;
    for (const Model& of : models()) {
        for (const Method& method : methods()) {
            for (const Precision precision : {Precision::float_, Precision::double_}) {
                const Exported run(of, method, precision);
                const std::string name = std::string(of.info.id) + " by " + std::string(method.info.id);
                EXPECT_EQ(run.file.method, method.info.id);
                EXPECT_EQ(run.file.dt, 0.03);
                if (of.info.id == "free" || refusal_of(run.model))
                    continue;  // the accelerations of `free` become fields
                ASSERT_FALSE(refusal_of(run.file)) << name << ": " << *refusal_of(run.file);
                Simulation direct(run.model), from_file(run.file);
                const std::uint64_t steps = direct.particles() > 100 ? 3 : 40;
                direct.advance(steps);
                from_file.advance(steps);
                EXPECT_EQ(direct.hash(), from_file.hash()) << name;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 2 * 5 * methods().size()) << "most of the pairs";
}

// Its accelerations become fields, which are computed in another order.
TEST(SceneChanges, free_particles_exported_fall_as_before) {
    for (const Method& method : methods()) {
        const Exported run(model("free"), method, Precision::double_);
        if (refusal_of(run.file)) continue;
        Simulation direct(run.model), from_file(run.file);
        direct.advance(40);
        from_file.advance(40);
        const Frame a = direct.frame(), b = from_file.frame();
        for (std::size_t i = 0; i < a.positions.size(); ++i)
            EXPECT_LT(length(a.positions[i] - b.positions[i]), 1e-13) << method.info.id;  // roundings of 40 steps
    }
}

}  // namespace
}  // namespace steplab::test
