#pragma once

#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// A word of numerical integration and what it means, in one to three sentences: tooltips, lessons and pages explain it
/// with the same ones.
struct Term {
    std::string_view id;     ///< the word itself: "stability limit"
    std::string_view text;   ///< what it means
    std::string_view words;  ///< other forms in which texts have it, separated by '|'
};

/// All of them, in the order in which beginners need them.
std::span<const Term> terms();

/// The term of this name; null if there is none.
const Term* find_term(std::string_view id);

/// True if a text has the term, or another form of it, as whole words, in capitals or not.
bool mentions(std::string_view text, const Term& term);

/// The explanations of all terms that a text mentions, in its order, one to a line: "order: ...". Empty if it has none.
std::string explanations(std::string_view text);

/// A text, and below it the explanations of the terms that another one mentions, if it has any.
std::string with_explanations(std::string_view text, std::string_view shown);

}  // namespace steplab
