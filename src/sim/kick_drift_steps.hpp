#pragma once

#include "methods/kick_drift.hpp"
#include "methods/system.hpp"
#include "models/layouts.hpp"

// The steps of kicks and drifts on every layout of forces: one translation unit compiles them for all methods that are
// such steps (kick_drift_steps.cpp).

#define STEPLAB_KICK_DRIFT_STEPS(prefix, T, Force) \
    prefix template void steplab::KickDriftSteps<T>::advance(steplab::System<T, steplab::Force<T>>&, std::uint64_t)
#define STEPLAB_ALL_KICK_DRIFT_STEPS(prefix, T)    \
    STEPLAB_KICK_DRIFT_STEPS(prefix, T, Constant); \
    STEPLAB_KICK_DRIFT_STEPS(prefix, T, Line);     \
    STEPLAB_KICK_DRIFT_STEPS(prefix, T, Grid);     \
    STEPLAB_KICK_DRIFT_STEPS(prefix, T, Pairs);    \
    STEPLAB_KICK_DRIFT_STEPS(prefix, T, NearPairs)

STEPLAB_ALL_KICK_DRIFT_STEPS(extern, float);
STEPLAB_ALL_KICK_DRIFT_STEPS(extern, double);
