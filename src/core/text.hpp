#pragma once

#include "core/number_text.hpp"

#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// "unknown model 'chian' (did you mean 'chain'?); known: free, oscillator, ...": one message for every unknown word.
/// `of` follows the word: "unknown parameter 'q' of mesh and rk4; known: ...".
std::string unknown_word(std::string_view kind, std::string_view word, std::span<const std::string_view> known,
                         std::string_view of = "");

/// The words of a list, separated: "a, b, c".
std::string joined(std::span<const std::string_view> words, std::string_view separator = ", ");

}  // namespace steplab
