#include "core/terms.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Terms, are_explained_in_one_to_three_sentences) {
    std::set<std::string_view> ids;
    for (const Term& term : terms()) {
        EXPECT_TRUE(ids.insert(term.id).second) << term.id;
        const std::string text = std::string(term.text) + " ";
        std::size_t sentences = 0;
        for (std::size_t i = text.find(". "); i != std::string::npos; i = text.find(". ", i + 1)) ++sentences;
        EXPECT_GE(sentences, 1u) << term.id;
        EXPECT_LE(sentences, 3u) << term.id;
        EXPECT_EQ(find_term(term.id), &term);
    }
    EXPECT_EQ(find_term("sympletic"), nullptr);
}

TEST(Terms, are_found_as_whole_words) {
    const Term& order = *find_term("order");
    EXPECT_TRUE(mentions("order 4 · symplectic", order));
    EXPECT_TRUE(mentions("Order, and cost", order));
    EXPECT_FALSE(mentions("border", order));
    EXPECT_FALSE(mentions("ordered", order));
    EXPECT_TRUE(mentions("the step size", *find_term("dt")));
}

// What the panel says of a method has its words explained: every property that an entry can have.
TEST(Terms, have_the_properties_of_methods) {
    for (const char* const id : {"order", "symplectic", "time-reversible", "adaptive", "implicit", "tolerance",
                                 "compensated", "stability limit", "force evaluations"})
        EXPECT_NE(find_term(id), nullptr) << id;
}

TEST(Terms, of_a_text_are_explained_in_its_order) {
    const std::string lines = explanations("symplectic · order 2");
    EXPECT_THAT(lines, StartsWith("symplectic: "));
    EXPECT_THAT(lines, HasSubstr("\norder: "));
    EXPECT_THAT(lines, Not(HasSubstr("tolerance")));
    EXPECT_EQ(explanations("a line of other words"), "");
    EXPECT_EQ(with_explanations("what it is", "other words"), "what it is");
    EXPECT_THAT(with_explanations("what it is", "order 2"), StartsWith("what it is\n\norder: "));
    EXPECT_THAT(with_explanations("", "order 2"), StartsWith("order: "));
}

}  // namespace
}  // namespace steplab
