#pragma once

#include "core/entry.hpp"

namespace steplab {

// Parameters that several models have, each with its own default.

constexpr ParameterInfo number_of_particles(double minimum, double default_value) {
    return {.name = "n",
            .kind = ParameterInfo::Kind::integer,
            .unit = "",
            .minimum = minimum,
            .default_value = default_value,
            .on_change = OnChange::restarts,
            .what = "number of particles",
            .slider_low = minimum,
            .slider_high = 100,
            .slider_logarithmic = true};
}

constexpr ParameterInfo particle_mass(double default_value, double slider_high = 10) {
    return {.name = "m",
            .unit = "kg",
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .what = "mass of a particle",
            .slider_low = 0.05,
            .slider_high = slider_high,
            .slider_logarithmic = true};
}

constexpr ParameterInfo force_constant(double default_value, std::string_view unit, double slider_high) {
    return {.name = "k",
            .unit = unit,
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .what = "force constant of a spring",
            .slider_low = 0.05,
            .slider_high = slider_high,
            .slider_logarithmic = true};
}

constexpr ParameterInfo well_depth(double default_value) {
    return {.name = "D",
            .unit = "J",
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .what = "depth of the Morse potential",
            .slider_low = 0.05,
            .slider_high = 10,
            .slider_logarithmic = true};
}

constexpr ParameterInfo well_force_constant(double default_value, double slider_low, double slider_high) {
    return {.name = "k",
            .unit = "N/m",
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .what = "force constant at the minimum, b = √(k/(2D))",
            .slider_low = slider_low,
            .slider_high = slider_high,
            .slider_logarithmic = true};
}

constexpr ParameterInfo well_distance(double default_value, double slider_low, double slider_high) {
    return {.name = "r0",
            .unit = "m",
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .what = "distance at the minimum of the potential",
            .slider_low = slider_low,
            .slider_high = slider_high};
}

constexpr ParameterInfo particles_along_edge(double default_value, double slider_low, double slider_high) {
    return {.name = "edge",
            .kind = ParameterInfo::Kind::integer,
            .unit = "",
            .minimum = 1,
            .default_value = default_value,
            .on_change = OnChange::restarts,
            .what = "number of particles along each edge of the cube",
            .slider_low = slider_low,
            .slider_high = slider_high};
}

constexpr ParameterInfo start_spacing(double default_value, double slider_low, double slider_high) {
    return {.name = "spacing",
            .unit = "m",
            .minimum = 0,
            .minimum_included = false,
            .default_value = default_value,
            .on_change = OnChange::restarts,
            .what = "initial distance between neighbours in the cube",
            .slider_low = slider_low,
            .slider_high = slider_high};
}

constexpr ParameterInfo rest_length(double default_value) {
    return {.name = "L",
            .unit = "m",
            .minimum = 0,
            .default_value = default_value,
            .on_change = OnChange::restarts,
            .what = "rest length of a spring",
            .slider_low = 0,
            .slider_high = 5};
}

constexpr ParameterInfo drag(double default_value) {
    return {.name = "c",
            .unit = "kg/s",
            .minimum = 0,
            .default_value = default_value,
            .what = "drag coefficient: force -c v",
            .slider_low = 0,
            .slider_high = 2};
}

constexpr ParameterInfo kick_speed(double default_value, std::string_view what) {
    return {.name = "v0",
            .unit = "m/s",
            .minimum = -infinity,
            .default_value = default_value,
            .on_change = OnChange::restarts,
            .what = what,
            .slider_low = -3,
            .slider_high = 3};
}

}  // namespace steplab
