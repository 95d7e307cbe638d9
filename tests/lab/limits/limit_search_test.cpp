#include "lab/limits/limit_search.hpp"

#include "core/entry.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace steplab::test {
namespace {

using Grows = std::function<bool(const GrowthQuestion&)>;

/// Number of rounds, and of questions in all of them.
struct Count {
    std::size_t rounds = 0, questions = 0;
};

double in_rounds(const LimitSearch& search, std::size_t most, const Grows& grows, Count& count) {
    return search.limit(most, [&](std::span<GrowthQuestion> questions) {
        EXPECT_GE(questions.size(), 1u);
        EXPECT_LE(questions.size(), most);
        ++count.rounds;
        count.questions += questions.size();
        for (GrowthQuestion& question : questions) question.grows = grows(question);
    });
}

double one_by_one(const LimitSearch& search, const Grows& grows, Count& count) {
    return search.limit([&](const GrowthQuestion& question) {
        ++count.rounds, ++count.questions;
        return grows(question);
    });
}

std::vector<LimitSearch> searches() {
    std::vector<LimitSearch> all;
    for (const double expected : {0.0, 0.3, 1.0, 1.0001, 30.0, infinity}) {
        for (const double above : {0.0, 1.0002 * expected})
            all.push_back({.expected = expected, .above = above < infinity ? above : 0, .time_scale = 1, .steps = 99});
    }
    return all;
}

/// A vibration that grows from this dt on; one that does so only in a narrow resonance; never and always.
std::vector<Grows> vibrations() {
    std::vector<Grows> all;
    for (const double limit : {0.0, 0.2, 0.5, 0.98, 0.99999, 1.00001, 1.00005, 1.0003, 1.005, 1.02, 3.0, infinity})
        all.emplace_back([=](const GrowthQuestion& question) { return question.dt > limit; });
    all.emplace_back([](const GrowthQuestion& question) { return question.dt > 1 && question.dt < 1.001; });
    return all;
}

TEST(LimitSearch, finds_in_rounds_the_same_bits_as_one_by_one) {
    for (const LimitSearch& search : searches()) {
        for (const Grows& grows : vibrations()) {
            Count alone;
            const double limit = one_by_one(search, grows, alone);
            for (const std::size_t most : {1U, 2U, 8U, 16U}) {
                Count together;
                EXPECT_EQ(in_rounds(search, most, grows, together), limit);
                EXPECT_LE(together.rounds, alone.rounds);
                EXPECT_TRUE(most > 1 || together.questions == alone.questions);
            }
        }
    }
}

/// The partner: a limit that differs by more than the last interval of the bisection is another number.
TEST(LimitSearch, finds_another_number_where_the_limit_is_another) {
    const LimitSearch search{.expected = 1, .above = 1.0001, .time_scale = 1, .steps = 99};
    const auto limit_of = [&](double limit) {
        Count count;
        return in_rounds(
            search, 8, [=](const GrowthQuestion& question) { return question.dt > limit; }, count);
    };
    EXPECT_NEAR(limit_of(1.00001), 1.00001, 3e-5);  // to the resolution of the bisection
    EXPECT_NE(limit_of(1.00001), limit_of(1.00005));
}

/// Two or three rounds instead of a dozen runs if theory is approximately right, more if it is far off.
TEST(LimitSearch, takes_few_rounds_where_theory_is_approximately_right) {
    const LimitSearch search{.expected = 1, .above = 1.0001, .time_scale = 1, .steps = 99};
    const Grows grows = [](const GrowthQuestion& question) { return question.dt > 0.99997; };
    Count alone, eight, sixteen, far;
    one_by_one(search, grows, alone);
    in_rounds(search, 8, grows, eight);
    in_rounds(search, 16, grows, sixteen);
    EXPECT_GE(alone.rounds, 10u);
    EXPECT_LE(eight.rounds, 3u);
    EXPECT_LE(sixteen.rounds, 2u);
    in_rounds(
        search, 8, [](const GrowthQuestion& question) { return question.dt > 0.4; }, far);
    EXPECT_GT(far.rounds, eight.rounds);
}

TEST(LimitSearch, refuses_to_search_where_theory_has_no_number) {
    const LimitSearch search{.expected = std::nan(""), .above = 0, .time_scale = 1, .steps = 99};
    Count count;
    const Grows never = [](const GrowthQuestion&) { return false; };
    EXPECT_THROW(one_by_one(search, never, count), UsageError);
    EXPECT_THROW(in_rounds(search, 8, never, count), UsageError);
    EXPECT_EQ(count.questions, 0u);
}

TEST(LimitSearch, continues_where_only_the_first_question_is_answered) {
    const LimitSearch search{.expected = 1, .above = 1.0001, .time_scale = 1, .steps = 99};
    const Grows grows = [](const GrowthQuestion& question) { return question.dt > 1.0007; };
    Count alone;
    const double limit = search.limit(
        8, [&](std::span<GrowthQuestion> questions) { questions.front().grows = grows(questions.front()); });
    EXPECT_EQ(limit, one_by_one(search, grows, alone));
}

// Growth of 0.3 % a step beyond all explicit limits is seen in 64 steps, and slower growth is not.
TEST(LimitSearch, tries_methods_without_a_limit_with_the_steps_that_are_set) {
    for (const double rate : {0.0, 0.001, 0.003, 0.01}) {
        LimitSearch search{.expected = infinity, .above = 0, .time_scale = 1, .steps = 99, .steps_beyond = 64};
        std::vector<double> tried;
        const Grows grows = [&](const GrowthQuestion& question) {
            if (question.steps != search.steps_beyond) return true;  // of the bisection after it
            tried.push_back(question.dt);
            const auto steps = static_cast<double>(question.steps);
            return rate * (steps - 3 * steps / 8) > question.allowed;  // from the early to the late maximum of a run
        };
        const double limit = search.limit(grows);
        EXPECT_EQ(limit < infinity, rate >= 0.003) << rate;
        const std::vector<double> all{1, 3, 10, 100, 1000};
        EXPECT_EQ(tried, limit == infinity ? all : std::vector<double>{1});
    }
}

}  // namespace
}  // namespace steplab::test
