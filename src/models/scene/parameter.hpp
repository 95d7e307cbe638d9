#pragma once

#include "core/entry.hpp"
#include "models/scene/written_number.hpp"

#include <string>
#include <string_view>

namespace steplab {

/// A parameter of a model as a quantity of its scene.
inline WrittenNumber parameter(const ParameterValues& values, std::string_view name) {
    return {values[name], std::string(name)};
}

}  // namespace steplab
