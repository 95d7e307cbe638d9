// Lessons and terms on the command line.

#include "app/program.hpp"
#include "io/files.hpp"
#include "session/lesson.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

TEST(ListLessons, says_what_each_teaches) {
    const Json list = Json::parse(run_program({"list", "lessons", "--json"}).out);
    const std::vector<Lesson> lessons = shipped_lessons();
    ASSERT_EQ(list.size(), lessons.size());
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        EXPECT_EQ(list[i].at("id"), lessons[i].id);
        EXPECT_EQ(list[i].at("title"), lessons[i].title);
        EXPECT_EQ(list[i].at("teaches"), lessons[i].teaches);
    }
    const std::string table = run_program({"list", "lessons"}).out;
    EXPECT_THAT(table, StartsWith(lessons.front().id));
    EXPECT_THAT(table, HasSubstr(lessons.back().title));
}

TEST(ListTerms, explains_them) {
    EXPECT_THAT(run_program({"list", "terms"}).out, HasSubstr("symplectic"));
    const Json list = Json::parse(run_program({"list", "terms", "--json"}).out);
    const auto dt = std::find_if(list.begin(), list.end(), [](const Json& term) { return term.at("id") == "dt"; });
    ASSERT_NE(dt, list.end());
    EXPECT_THAT(dt->at("title").get<std::string>(), HasSubstr("time step"));
}

TEST(ReplayLesson, prints_facts_and_finds_a_wrong_one) {
    const Outcome right = run_program({"replay", "--lesson", "half-the-step"});
    EXPECT_EQ(right.code, 0) << right.err;
    EXPECT_THAT(right.out, HasSubstr("page 3  ok     position error of run 0 over run 1: 16.6"));
    const TemporaryFolder folder;
    const std::string lessons = std::string(STEPLAB_SOURCE_DIR) + "/assets/lessons/half-the-step";
    std::string text = text_of(lessons + ".toml");
    const std::string bounds = "between = [15, 18]";
    ASSERT_NE(text.find(bounds), std::string::npos);
    put_text(folder.file("mine.toml"), text.replace(text.find(bounds), bounds.size(), "between = [7, 9]"));
    put_text(folder.file("mine.session"), text_of(lessons + ".session"));
    const Outcome wrong = run_program({"replay", "--lesson", folder.file("mine.toml")});
    EXPECT_EQ(wrong.code, 6);
    EXPECT_THAT(wrong.out, HasSubstr("page 3  WRONG"));
    EXPECT_THAT(wrong.err, HasSubstr("1 fact not as stated"));
}

TEST(ReplayLesson, of_a_session_file_alone_is_a_replay) {
    const Outcome outcome =
        run_program({"replay", std::string(STEPLAB_SOURCE_DIR) + "/assets/lessons/half-the-step.session"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("8 events"));
}

TEST(LessonFile, that_is_broken_has_one_message_and_exit_code_3) {
    const TemporaryFolder folder;
    put_text(folder.file("mine.toml"), "steplab-lesson = 1\ntitel = \"a\"\n");
    put_text(folder.file("mine.session"),
             text_of(std::string(STEPLAB_SOURCE_DIR) + "/assets/lessons/one-step.session"));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"replay", "--lesson"}, {"view", "--lesson"}}) {
        const Outcome outcome = run_program({command[0], command[1], folder.file("mine.toml")});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("mine.toml:2:1: unknown key 'titel' of a lesson file (did you mean "
                                           "'title'?)"));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    }
}

TEST(LessonOption, is_checked_before_a_window_opens) {
    EXPECT_EQ(run_program({"view", "--lesson", "no-such"}).code, 2);
    const Outcome with_scene = run_program({"view", "--lesson", "one-step", "--model", "chain"});
    EXPECT_EQ(with_scene.code, 2);
    EXPECT_THAT(with_scene.err, HasSubstr("has a scene of its own"));
    EXPECT_EQ(run_program({"view", "--lesson", "one-step", "--session", "a.session"}).code, 2);
    EXPECT_EQ(run_program({"replay", "a.session", "--lesson", "one-step"}).code, 2);
    EXPECT_EQ(run_program({"list", "lesson"}).code, 2);
}

}  // namespace
}  // namespace steplab
