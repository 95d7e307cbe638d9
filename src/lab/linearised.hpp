#pragma once
#include "sim/run_description.hpp"
namespace steplab {
double omega_max(const RunDescription&);
}
