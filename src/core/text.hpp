#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// Shortest text that reads back as the same number; "nan", "inf", "-inf" if it is not finite. Independent of the
/// user's locale.
std::string number_text(double value);
/// The same for a number of a float run: the shortest text that reads back as the same float.
std::string number_text(float value);

/// The number written as `text` (decimal or scientific, with an optional sign); nullopt if it is anything else.
std::optional<double> parse_number(std::string_view text);

/// "unknown model 'chian' (did you mean 'chain'?); known: free, oscillator, ...": one message for every unknown word.
/// `of` follows the word: "unknown parameter 'q' of mesh and rk4; known: ...".
std::string unknown_word(std::string_view kind, std::string_view word, std::span<const std::string_view> known,
                         std::string_view of = "");

/// The words of a list, separated: "a, b, c".
std::string joined(std::span<const std::string_view> words, std::string_view separator = ", ");

}  // namespace steplab
