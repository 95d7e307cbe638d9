#include "sim/kick_drift_steps.hpp"

STEPLAB_ALL_KICK_DRIFT_STEPS(, float);
STEPLAB_ALL_KICK_DRIFT_STEPS(, double);
