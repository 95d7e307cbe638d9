#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// Numbers as text, of two kinds, both independent of the user's locale.

/// Exact, for files, command lines and text entries: the shortest text that reads back as the same number; "nan", "inf"
/// or "-inf" if it is not finite.
std::string number_text(double value);
/// The same for a number of a float run: the shortest text that reads back as the same float.
std::string number_text(float value);

/// The same text with an exponent as people write it, for values that are typed and read: "1e-7" for "1e-07".
std::string exact_text(double value);

/// The number written as `text` (decimal or scientific, with an optional sign); nullopt if it is anything else.
std::optional<double> parse_number(std::string_view text);

/// Readable, for people: rounded to `digits` significant digits. "0.21", "1500", and "2.3·10⁻⁷" where a decimal would
/// be long (below 0.001 or from 10 000); a power of ten alone as "10⁻⁶". Digits before the point are never rounded.
std::string readable(double value, int digits = 2);
/// The same in characters that can be typed: "0.21", "2.3e-7", "1e-6".
std::string typed(double value, int digits = 2);

/// Readable, in a sentence: at most `digits` significant digits, without zeros at the end: "1.434", "120000", "1.2e-7".
std::string significant(double value, int digits);

/// Readable, a value that a person sets: without trailing zeros, but with one decimal. "2.0", "0.25", "1.9e6", "∞".
std::string setting_text(double value, int digits = 4);
/// Readable, a value that changes by itself: three digits with trailing zeros, so that its width is steady. "0.500".
std::string reading_text(double value);
/// Readable, an error or a rate, of which two digits say enough: "2.1e-7", "0.31", "0".
std::string rounded_text(double value);

/// Readable, a result: at most 4 significant digits, but an integer part below 10 million is not rounded: "0.7",
/// "68.1", "12346", "1.2e-7".
std::string short_number(double value);

/// A count in groups of three digits, separated by narrow spaces that do not break: "12 345 678".
std::string grouped(unsigned long long count);

}  // namespace steplab
