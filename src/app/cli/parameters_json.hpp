#pragma once

#include "core/entry.hpp"

#include <nlohmann/json.hpp>

#include <span>

namespace steplab {

/// JSON has no infinity: no limit is null.
nlohmann::ordered_json json_number(double value);

/// All that is known of each parameter.
nlohmann::ordered_json parameters_json(std::span<const ParameterInfo> parameters);

}  // namespace steplab
