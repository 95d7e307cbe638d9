#pragma once

#include "core/coupling.hpp"

#include <optional>
#include <string>

namespace steplab {

/// Methods whose integrator computes in every lane of a number type as in a number by itself.
template <class Method>
inline constexpr bool goes_in_lanes = requires {
    Method::template Integrator<double>::goes_in_lanes;
};

/// The method's `refusal`, null if it runs every scene.
template <class Method>
constexpr auto refusal_of() -> std::optional<std::string> (*)(const Coupling&) {
    if constexpr (requires(const Coupling& coupling) { Method::refusal(coupling); }) {
        return &Method::refusal;
    } else {
        return nullptr;
    }
}

/// The method's `bytes_of_interactions`, null if it holds nothing for them.
template <class Method>
constexpr auto bytes_of_interactions_of() -> double (*)(const Coupling&, double) {
    if constexpr (requires(const Coupling& coupling) { Method::bytes_of_interactions(coupling, 0.0); }) {
        return &Method::bytes_of_interactions;
    } else {
        return nullptr;
    }
}

}  // namespace steplab
