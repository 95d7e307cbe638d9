// Lessons: every one that is shipped states what its session computes, and broken files are answered.

#include "session/lesson.hpp"

#include "core/error.hpp"
#include "core/terms.hpp"
#include "io/files.hpp"
#include "io/shared_files.hpp"
#include "session/lesson_check.hpp"
#include "session/session_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string described(const CheckedFact& each) {
    return fmt::format("page {}, \"{}\": {} of run {} is {}, stated between {} and {}", each.page + 1, each.fact.says,
                       each.fact.quantity, each.fact.run, each.value, each.fact.least, each.fact.most);
}

/// The numbers of a text as it has them: "10 000", "4e-10".
std::vector<std::string> numbers_in(const std::string& text) {
    std::vector<std::string> numbers;
    const auto is_digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_digit(i) || (i > 0 && std::isalpha(static_cast<unsigned char>(text[i - 1])) != 0)) continue;
        std::size_t end = i;
        const auto joins = [&] {
            const bool point = text[end] == '.' && is_digit(end + 1);
            const bool thousands = text[end] == ' ' && is_digit(end + 1) && is_digit(end + 2) && is_digit(end + 3);
            const bool power = text[end] == 'e' && (is_digit(end + 1) || is_digit(end + 2));
            return point || thousands || power || (text[end] == '-' && text[end - 1] == 'e');
        };
        while (end < text.size() && (is_digit(end) || joins())) ++end;
        numbers.push_back(text.substr(i, end - i));
        i = end;
    }
    return numbers;
}

double value_of(const std::string& says, std::string number) {
    number.erase(std::remove(number.begin(), number.end(), ' '), number.end());
    const double value = std::stod(number);
    if (says.find('%') != std::string::npos) return value / 100;
    return says.find("mm") != std::string::npos ? value / 1000 : value;
}

/// The number that a fact says is between its bounds, where it says one; of a bound, at the side that it says.
bool agrees(const LessonFact& fact) {
    const std::vector<std::string> numbers = numbers_in(fact.says);
    if (numbers.empty()) return true;
    const double value = value_of(fact.says, numbers.front());
    const double least = std::min(std::abs(fact.least), std::abs(fact.most));
    const double most = std::max(std::abs(fact.least), std::abs(fact.most));
    const bool is_bound = fact.says.find("below") != std::string::npos || fact.says.find("within") != std::string::npos;
    return is_bound ? most <= value : least <= value && value <= most;
}

class ShippedLesson : public testing::TestWithParam<std::string> {
protected:
    const Lesson lesson = find_lesson(GetParam());
};

TEST_P(ShippedLesson, states_what_its_session_computes) {
    for (const CheckedFact& each : check_facts(lesson)) EXPECT_TRUE(each.holds()) << described(each);
}

TEST_P(ShippedLesson, has_a_fact_for_every_number_that_it_shows) {
    for (const LessonPage& page : lesson.pages) {
        for (const LessonFact& fact : page.facts) EXPECT_TRUE(agrees(fact)) << fact.says;
        for (const std::string& number : numbers_in(page.shows)) {
            const bool stated = std::any_of(page.facts.begin(), page.facts.end(), [&](const LessonFact& fact) {
                return fact.says.find(number) != std::string::npos;
            });
            const bool given = (page.text + page.act).find(number) != std::string::npos;
            EXPECT_TRUE(stated || given) << page.title << ": " << number;
        }
    }
}

TEST_P(ShippedLesson, does_something_and_explains_its_words) {
    EXPECT_FALSE(lesson.teaches.empty());
    const bool does = std::all_of(lesson.pages.begin(), lesson.pages.end(), [](const LessonPage& page) {
        return page.has_part() && !page.facts.empty() && !page.plots.empty() && page.speed && !page.terms.empty();
    });
    EXPECT_TRUE(does);
    EXPECT_EQ(lesson.pages.back().to, lesson.session->events.size()) << "nothing is recorded behind the last page";
}

// The partner of the facts that hold: the same one with other bounds does not.
TEST_P(ShippedLesson, with_another_number_is_found_wrong) {
    Lesson wrong = lesson;
    LessonFact& fact = wrong.pages.front().facts.front();
    fact.least = fact.most + 1;
    fact.most = fact.least + 1;
    const std::vector<CheckedFact> facts = check_facts(wrong);
    EXPECT_FALSE(facts.front().holds()) << described(facts.front());
    EXPECT_TRUE(std::all_of(facts.begin() + 1, facts.end(), [](const CheckedFact& each) { return each.holds(); }));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLesson, testing::ValuesIn(shared_names("lessons", ".toml")),
                         [](const auto& lesson) {
                             std::string name = lesson.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(Lessons, are_many_and_in_an_order_of_their_own) {
    const std::vector<Lesson> lessons = shipped_lessons();
    EXPECT_GE(lessons.size(), 12u);
    for (std::size_t i = 1; i < lessons.size(); ++i) EXPECT_LT(lessons[i - 1].order, lessons[i].order) << lessons[i].id;
}

TEST(Lessons, of_an_unknown_name_have_a_nearest_one) {
    try {
        find_lesson("one-stpe");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("unknown lesson 'one-stpe' (did you mean 'one-step'?)"));
    }
}

constexpr const char* small_session =
    "steplab-session = 1\n[start]\nmodel = \"oscillator\"\nparameters = {}\nmethod = \"rk4\"\nprecision = \"double\"\n"
    "dt = 0.1\n[[events]]\nstep = 5\ndo = \"bookmark\"\ntext = \"five\"\n[[events]]\nstep = 9\ndo = \"bookmark\"\n"
    "text = \"nine\"\n";
const std::string small_lesson =
    "steplab-lesson = 1\ntitle = \"a\"\nteaches = \"b\"\n[[pages]]\ntitle = \"c\"\ntext = \"d\"\ndo = \"e\"\n"
    "watch = \"f\"\nshows = \"5 steps\"\nto = \"five\"\nplots = [\"energies\"]\nterms = [\"dt\"]\nspeed = 2\n"
    "[[pages.facts]]\nsays = \"5 steps\"\nquantity = \"steps\"\nbetween = [5, 5]\n";

Lesson parsed(const std::string& text) {
    return parse_lesson(text, "a.toml", parse_session(small_session, "a.session"));
}

std::string refusal(const std::string& text) {
    try {
        parsed(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

std::string with(const std::string& from, const std::string& to) {
    std::string text = small_lesson;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

TEST(LessonFile, is_read_as_it_is_written) {
    const Lesson lesson = parsed(small_lesson);
    ASSERT_EQ(lesson.pages.size(), 1u);
    EXPECT_EQ(lesson.pages[0].from, 0u);
    EXPECT_EQ(lesson.pages[0].to, 1u);
    EXPECT_EQ(lesson.pages[0].speed, 2);
    const std::vector<CheckedFact> facts = check_facts(lesson);
    ASSERT_EQ(facts.size(), 1u);
    EXPECT_EQ(facts[0].value, 5);
    EXPECT_TRUE(facts[0].holds());
}

TEST(LessonFile, has_a_place_and_the_right_word_for_what_is_wrong) {
    const std::vector<std::vector<std::string>> cases{
        {"steplab-lesson = 1\n", "", "a.toml:1:1: a lesson file begins with its version: steplab-lesson = 1"},
        {"steplab-lesson = 1", "steplab-lesson = 2", "a.toml:1:18: this program reads version 1"},
        {"teaches", "teachs", "a.toml:3:1: unknown key 'teachs' of a lesson file (did you mean 'teaches'?)"},
        {"watch", "wacth", "a.toml:8:1: unknown key 'wacth' of [[pages]] (did you mean 'watch'?)"},
        {"to = \"five\"", "to = \"fife\"", "a.toml:10:6: unknown bookmark 'fife'"},
        {"to = \"five\"\n", "", "needs 'to', the bookmark"},
        {"shows = \"5 steps\"\n", "", "a page with 'to' needs 'shows'"},
        {"energies", "energy", "a.toml:11:10: unknown plot 'energy'"},
        {"[\"dt\"]", "[\"dtt\"]", "a.toml:12:10: unknown term 'dtt'"},
        {"speed = 2", "speed = 0", "a.toml:13:9: a speed must be > 0"},
        {"says = \"5", "says = \"6", "the page does not have the words of its fact: \"6 steps\""},
        {"\"steps\"", "\"step\"", "a.toml:16:12: unknown quantity 'step' (did you mean 'steps'?)"},
        {"[5, 5]", "[5, 4]", "the first number must not be greater than the second"},
        {"[5, 5]", "5", "a.toml:17:11: must be two numbers, [from, to]"}};
    for (const auto& each : cases) EXPECT_THAT(refusal(with(each[0], each[1])), HasSubstr(each[2])) << each[1];
}

// Whatever is missing at the end, there is one message with a place, or a lesson that is whole.
TEST(LessonFile, truncated_anywhere_is_answered) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < small_lesson.size(); ++length) {
        const std::string message = refusal(small_lesson.substr(0, length));
        if (message == "none") continue;
        EXPECT_THAT(message, StartsWith("a.toml:")) << length;
        EXPECT_EQ(message.find('\n'), std::string::npos) << length;
        ++refused;
    }
    EXPECT_GT(refused, small_lesson.size() / 2);
}

TEST(LessonFile, needs_its_session_beside_it) {
    const TemporaryFolder folder;
    put_text(folder.file("mine.toml"), small_lesson);
    EXPECT_THROW(read_lesson_file(folder.file("mine.toml")), FileError);
    put_text(folder.file("mine.session"), small_session);
    EXPECT_EQ(find_lesson(folder.file("mine.toml")).id, "mine");
}

TEST(LessonCheck, leaves_what_is_not_reached_unknown) {
    Lesson lesson = parsed(small_lesson);
    lesson.pages[0].facts[0].step = 7;  // the page ends at step 5
    EXPECT_TRUE(std::isnan(check_facts(lesson)[0].value));
    EXPECT_FALSE(check_facts(lesson)[0].holds());
    lesson.pages[0].facts[0].step = 3;
    EXPECT_EQ(check_facts(lesson)[0].value, 3);
    lesson.pages[0].facts[0].run = 2;  // there is one run
    EXPECT_FALSE(check_facts(lesson)[0].holds());
}

// At step 5 the session goes back and kicks: at step 3 it is then elsewhere.
TEST(LessonCheck, measures_a_step_where_it_is_passed_first) {
    const std::string session = std::string(small_session).substr(0, std::string(small_session).find("[[events]]")) +
                                "[[events]]\nstep = 5\ndo = \"seek\"\nto = 0\n[[events]]\nstep = 0\ndo = \"kick\"\n"
                                "particle = 1\nvelocity = [1, 0, 0]\n[[events]]\nstep = 9\ndo = \"bookmark\"\n"
                                "text = \"five\"\n";
    Lesson lesson = parse_lesson(small_lesson, "a.toml", parse_session(session, "a.session"));
    LessonFact& fact = lesson.pages[0].facts[0];
    fact.quantity = "distance from start";
    fact.step = 3;
    EXPECT_NEAR(check_facts(lesson)[0].value, std::sin(0.3), 1e-6);  // sin t for v0 = 1, ω = 1, to the error of rk4
    fact.step.reset();
    EXPECT_GT(check_facts(lesson)[0].value, 1) << "kicked, it swings twice as far";
}

// Each quantity of a swing of rk4 in double at dt = 0.1 is a number; exact ones are compared.
TEST(LessonCheck, knows_every_quantity) {
    Lesson lesson = parsed(small_lesson);
    const LessonFact fact = lesson.pages[0].facts[0];
    lesson.pages[0].facts.clear();
    for (const LessonQuantity& quantity : lesson_quantities) {
        lesson.pages[0].facts.push_back(fact);
        lesson.pages[0].facts.back().quantity = quantity.id;
    }
    std::map<std::string, double> known;
    for (const CheckedFact& each : check_facts(lesson)) {
        if (each.fact.quantity == "momentum error") continue;  // the wall takes momentum
        EXPECT_TRUE(std::isfinite(each.value)) << each.fact.quantity;
        known[each.fact.quantity] = each.value;
    }
    EXPECT_DOUBLE_EQ(known["time"], 0.5);
    EXPECT_EQ(known["evaluations"], 20);
    EXPECT_NEAR(known["distance from start"], std::sin(0.5), 1e-6);  // sin t for v0 = 1, ω = 1, to the error of rk4
    EXPECT_EQ(known["diverged"], 0);
}

}  // namespace
}  // namespace steplab
