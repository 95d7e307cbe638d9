#include "app/film/series_name.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace steplab {
namespace {

/// What stands behind a percent sign.
struct Field {
    int digits = 1;
    std::size_t length = 1;
};

/// "d" or "05d" at the beginning of a text.
std::optional<Field> field_of(std::string_view text) {
    constexpr int most_digits = 20;
    if (text.starts_with('d')) return Field{};
    if (!text.starts_with('0')) return std::nullopt;  // a name with blanks in place of zeros is no help
    int digits = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), digits);
    if (error != std::errc() || digits < 1 || digits > most_digits) return std::nullopt;
    const auto length = static_cast<std::size_t>(end - text.data());
    if (length == text.size() || text[length] != 'd') return std::nullopt;
    return Field{digits, length + 1};
}

[[noreturn]] void refuse(const std::string& pattern) {
    throw UsageError(
        fmt::format("--out: the name of a series of pictures has one number, such as frames/%05d.png (got \"{}\")",
                    shown(pattern)));
}

}  // namespace

SeriesName::SeriesName(const std::string& pattern) {
    const std::size_t folder = pattern.rfind('/') + 1;  // 0 without one
    bool numbered = false;
    before_ = pattern.substr(0, folder);
    for (std::size_t i = folder; i < pattern.size(); ++i) {
        std::string& text = numbered ? after_ : before_;
        if (pattern[i] != '%') {
            text += pattern[i];
        } else if (pattern.compare(i, 2, "%%") == 0) {
            text += pattern[i++];
        } else {
            const auto field = field_of(std::string_view(pattern).substr(i + 1));
            if (!field || numbered) refuse(pattern);
            digits_ = field->digits;
            i += field->length;
            numbered = true;
        }
    }
    if (!numbered) refuse(pattern);
}

std::string SeriesName::of(std::uint64_t number) const {
    return fmt::format("{}{:0{}}{}", before_, number, digits_, after_);
}

}  // namespace steplab
