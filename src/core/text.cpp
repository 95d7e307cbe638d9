#include "core/text.hpp"

#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// Levenshtein distance: the number of single-letter changes that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, changed}));
        }
    }
    return row.back();
}

/// The known word that differs by a typing error, if there is one.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known) {
    const auto closest = std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return edit_distance(word, a) < edit_distance(word, b);
    });
    if (closest == known.end() || closest->size() < 3) return std::nullopt;
    if (edit_distance(word, *closest) > (closest->size() < 4 ? 1U : 2U)) return std::nullopt;
    return *closest;
}

}  // namespace

std::string joined(std::span<const std::string_view> words, std::string_view separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

std::string unknown_word(std::string_view kind, std::string_view word, std::span<const std::string_view> known,
                         std::string_view of) {
    constexpr std::size_t most = 60;  // more than any catalogue of the program has
    const auto guess = nearest(word, known);
    const std::string all = known.empty() ? "there is none"
                            : known.size() > most
                                ? fmt::format("known: {} ... ({} in all)", joined(known.first(most)), known.size())
                                : "known: " + joined(known);
    return fmt::format("unknown {} '{}'{}{}{}; {}", kind, shown(word), of.empty() ? "" : " of ", of,
                       guess ? fmt::format(" (did you mean '{}'?)", *guess) : "", all);
}

}  // namespace steplab
