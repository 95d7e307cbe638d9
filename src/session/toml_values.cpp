#include "session/toml_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace steplab {

double number_of(const toml::node& node) {
    const auto* const integer = node.as_integer();
    const auto* const real = node.as_floating_point();
    if (!integer && !real) fail_at(node, "must be a number");
    const double number = integer ? static_cast<double>(integer->get()) : real->get();
    if (!std::isfinite(number)) fail_at(node, "must be a finite number");
    return number;
}

std::int64_t integer_of(const toml::node& node) {
    constexpr std::int64_t most = std::int64_t{1} << 53;
    const auto* const integer = node.as_integer();
    if (integer && integer->get() >= -most && integer->get() <= most) return integer->get();
    fail_at(node, fmt::format("must be an integer from {} to {}", -most, most));
}

std::uint64_t count_of(const toml::node& node) {
    const std::int64_t integer = integer_of(node);
    if (integer < 0) fail_at(node, "must be an integer >= 0");
    return static_cast<std::uint64_t>(integer);
}

const toml::node& needed(const toml::table& table, std::string_view what, std::string_view key) {
    if (const toml::node* const node = table.get(key)) return *node;
    fail_at(table, fmt::format("{} needs '{}'", what, key));
}

void check_keys(const toml::table& table, std::string_view what, std::span<const std::string_view> keys) {
    std::vector<KeyHandler> handlers;
    for (const std::string_view key : keys) handlers.push_back({key, [](const toml::node&) {}});
    read_keys(table, what, handlers);
}

}  // namespace steplab
