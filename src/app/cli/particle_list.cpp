#include "app/cli/particle_list.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace steplab {

namespace {

std::size_t parse_index(std::string_view text, std::string_view option, std::string_view list, std::size_t count) {
    std::size_t index = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), index);
    if (result.ec == std::errc::invalid_argument || result.ptr != text.data() + text.size()) {
        throw UsageError(fmt::format("{} '{}' is not a list of particles such as 9,0-3", option, shown(list)));
    }
    if (result.ec != std::errc{} || index >= count) {
        throw UsageError(fmt::format("{} {}: no particle {}; this scene has {}, numbered 0 to {}", option, shown(list),
                                     shown(text), count, count - 1));
    }
    return index;
}

}  // namespace

std::vector<std::size_t> parse_particles(std::string_view option, std::string_view text, std::size_t count) {
    std::vector<bool> chosen(count);
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view item = text.substr(begin, end - begin);
        const std::size_t dash = item.find('-');
        const std::size_t first = parse_index(item.substr(0, dash), option, text, count);
        const std::size_t last =
            dash == std::string_view::npos ? first : parse_index(item.substr(dash + 1), option, text, count);
        if (last < first)
            throw UsageError(fmt::format("{} {}: the range {} is backwards", option, shown(text), shown(item)));
        std::fill_n(chosen.begin() + static_cast<std::ptrdiff_t>(first), last - first + 1, true);
        begin = end + 1;
    }
    std::vector<std::size_t> particles;
    for (std::size_t i = 0; i < count; ++i) {
        if (chosen[i]) particles.push_back(i);
    }
    return particles;
}

}  // namespace steplab
