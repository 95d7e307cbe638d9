#pragma once

// What the sources of the module share.

#include <map>
#include <optional>
#include <pybind11/pybind11.h>
#include <steplab/run.hpp>
#include <steplab/scene.hpp>
#include <string>

namespace steplab::python {

namespace py = pybind11;

/// Parameters as Python gives them: texts by name.
library::Parameters parameters_of(const std::map<std::string, std::string>& texts);
std::map<std::string, std::string> texts_of(const library::Parameters& parameters);

/// The keys of a run's settings: method, dt, precision, parameters, threads.
library::Settings settings_of(const py::dict& given);

/// Adds to the module what makes runs, and what the lab measures.
void add_runs(py::module_& core);
void add_lab(py::module_& core);

}  // namespace steplab::python
