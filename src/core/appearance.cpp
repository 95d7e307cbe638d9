#include "core/appearance.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>

namespace steplab {
namespace {

constexpr std::array<std::string_view, 4> view_words = {"default", "front", "side", "top"};

std::size_t index_of(std::string_view kind, std::string_view word, std::span<const std::string_view> known) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) throw UsageError(unknown_word(kind, word, known));
    return static_cast<std::size_t>(found - known.begin());
}

bool read_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

bool read_numbers(std::string_view text, std::array<double, 6>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t comma = text.find(',');
        const bool last = i + 1 == numbers.size();
        if (last != (comma == std::string_view::npos) || !read_number(text.substr(0, comma), numbers[i])) return false;
        if (!last) text.remove_prefix(comma + 1);
    }
    return true;
}

void check_lengths(const WrittenView& view, std::string_view text, std::string_view name) {
    const Vec3& focus = view.focus;
    const double farthest = std::max({std::abs(focus.x), std::abs(focus.y), std::abs(focus.z), view.distance});
    if (view.distance >= least_distance && farthest <= largest_length) return;
    throw UsageError(fmt::format("{}: the distance must be from {} to {}, x, y and z from -{} to {} (got {})", name,
                                 typed(least_distance), typed(largest_length), typed(largest_length),
                                 typed(largest_length), shown(text)));
}

}  // namespace

Colouring colouring_of(std::string_view word) {
    return static_cast<Colouring>(index_of("colouring", word, colouring_ids));
}

Background background_of(std::string_view word) {
    return static_cast<Background>(index_of("background", word, background_ids));
}

WrittenView parse_view(std::string_view text, std::string_view name) {
    const auto* const word = std::find(view_words.begin(), view_words.end(), text);
    if (word != view_words.end()) return {.word = *word};
    std::array<double, 6> numbers{};
    if (!read_numbers(text, numbers) || std::abs(numbers[1]) > 90 || !(numbers[2] > 0)) {
        throw UsageError(
            fmt::format("{} must be default, front, side, top or yaw,pitch,distance,x,y,z with angles in "
                        "degrees, pitch from -90 to 90, distance > 0 and the point x,y,z at the centre "
                        "(got \"{}\")",
                        name, shown(text)));
    }
    const WrittenView view{
        .yaw = numbers[0], .pitch = numbers[1], .distance = numbers[2], .focus = {numbers[3], numbers[4], numbers[5]}};
    check_lengths(view, text, name);
    return view;
}

}  // namespace steplab
