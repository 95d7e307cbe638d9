#pragma once

#include "core/entry.hpp"

namespace steplab {

/// The parameter of every adaptive method.
inline constexpr ParameterInfo tolerance_parameter{.name = "tolerance",
                                                   .kind = ParameterInfo::Kind::real,
                                                   .unit = "",
                                                   .minimum = 0,
                                                   .minimum_included = false,
                                                   .default_value = 1e-9,
                                                   .what = "error allowed, absolute and relative alike",
                                                   .slider_low = 1e-14,
                                                   .slider_high = 1e-2,
                                                   .slider_logarithmic = true};

}  // namespace steplab
