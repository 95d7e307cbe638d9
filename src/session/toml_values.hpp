#pragma once

#include "io/scene_toml.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace steplab {

// Values of TOML files that hold exact numbers: sessions and lessons. Anything else throws SceneProblem.

/// A finite number.
double number_of(const toml::node& node);
/// An integer of at most 53 bits.
std::int64_t integer_of(const toml::node& node);
/// One that is not negative.
std::uint64_t count_of(const toml::node& node);

/// What a key of a table has, which must be there; `what` names the table in messages.
const toml::node& needed(const toml::table& table, std::string_view what, std::string_view key);
/// The keys of a table are among these.
void check_keys(const toml::table& table, std::string_view what, std::span<const std::string_view> keys);

}  // namespace steplab
