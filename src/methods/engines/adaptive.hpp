#pragma once

#include "core/entry.hpp"

namespace steplab {

/// The parameter of every method that chooses its own steps.
inline constexpr ParameterInfo tolerance_parameter{.name = "tolerance",
                                                   .unit = "",
                                                   .minimum = 0,
                                                   .minimum_included = false,
                                                   .default_value = 1e-9,
                                                   .what = "allowed error per step, absolute and relative",
                                                   .slider_low = 1e-14,
                                                   .slider_high = 1e-2,
                                                   .slider_logarithmic = true};

}  // namespace steplab
