#pragma once

/// The whole public interface of steplab; each header may be included by itself. Units are the scene's own and
/// consistent: m, kg, s, N, J, if you like.

#include <steplab/error.hpp>
#include <steplab/expression.hpp>
#include <steplab/lab.hpp>
#include <steplab/method.hpp>
#include <steplab/run.hpp>
#include <steplab/scene.hpp>
#include <steplab/simulation.hpp>
#include <steplab/version.hpp>
