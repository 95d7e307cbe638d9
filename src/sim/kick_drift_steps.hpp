#pragma once

#include "methods/kick_drift.hpp"
#include "methods/system.hpp"
#include "models/layouts.hpp"

#include <cstdint>

namespace steplab {

// The steps of kicks and drifts on every layout of forces are compiled once, for all methods that are such steps
// (kick_drift_steps.cpp).

extern template void KickDriftSteps<float>::advance(System<float, Constant<float>>&, std::uint64_t);
extern template void KickDriftSteps<float>::advance(System<float, Line<float>>&, std::uint64_t);
extern template void KickDriftSteps<float>::advance(System<float, Grid<float>>&, std::uint64_t);
extern template void KickDriftSteps<float>::advance(System<float, Pairs<float>>&, std::uint64_t);
extern template void KickDriftSteps<float>::advance(System<float, NearPairs<float>>&, std::uint64_t);
extern template void KickDriftSteps<double>::advance(System<double, Constant<double>>&, std::uint64_t);
extern template void KickDriftSteps<double>::advance(System<double, Line<double>>&, std::uint64_t);
extern template void KickDriftSteps<double>::advance(System<double, Grid<double>>&, std::uint64_t);
extern template void KickDriftSteps<double>::advance(System<double, Pairs<double>>&, std::uint64_t);
extern template void KickDriftSteps<double>::advance(System<double, NearPairs<double>>&, std::uint64_t);

}  // namespace steplab
