// Runs and trajectories for Python.

#include "arrays.hpp"
#include "core.hpp"
#include "interruptible.hpp"

#include <pybind11/stl.h>
#include <steplab/simulation.hpp>
#include <utility>

namespace steplab::python {

namespace {

using library::Simulation;

/// Energies are left out where a file has none.
py::dict arrays_of(library::Recording rows) {
    const auto frames = static_cast<py::ssize_t>(rows.times.size());
    const std::vector<py::ssize_t> vectors{frames, static_cast<py::ssize_t>(rows.particles), 3};
    py::dict arrays;
    arrays["steps"] = array_of(std::move(rows.steps));
    arrays["times"] = array_of(std::move(rows.times));
    if (frames == 0 || !rows.positions.empty()) arrays["positions"] = array_of(std::move(rows.positions), vectors);
    if (frames == 0 || !rows.velocities.empty()) arrays["velocities"] = array_of(std::move(rows.velocities), vectors);
    if (rows.energy.empty()) return arrays;
    arrays["kinetic"] = array_of(std::move(rows.kinetic));
    arrays["potential"] = array_of(std::move(rows.potential));
    arrays["energy"] = array_of(std::move(rows.energy));
    arrays["energy_error"] = array_of(std::move(rows.energy_error));
    return arrays;
}

py::dict run(const library::Scene& scene, const py::dict& given, std::optional<std::uint64_t> steps,
             std::optional<double> until, std::uint64_t every, bool positions, bool velocities) {
    const library::Settings settings = settings_of(given);
    library::Result result = interruptible([&] {
        return library::run(scene, settings, {steps, until}, {every, positions, velocities});
    });
    py::dict run = arrays_of(std::move(result.rows));
    run["method"] = result.method;
    run["precision"] = result.precision;
    run["dt"] = result.dt;
    run["evaluations"] = result.evaluations;
    run["status"] = result.status;
    run["reason"] = result.reason;
    run["hash"] = result.hash;
    run["notes"] = result.notes;
    run["error"] = result.error;
    run["wall_seconds"] = result.wall_seconds;
    return run;
}

py::dict read(const std::string& file, std::uint64_t first, std::uint64_t every) {
    library::Trajectory trajectory = interruptible([&] { return library::read(file, first, every); });
    py::dict rows = arrays_of(std::move(trajectory.rows));
    rows["run"] = trajectory.run;
    rows["complete"] = trajectory.complete;
    rows["fault"] = trajectory.fault;
    return rows;
}

/// Fills an array that was checked (_arrays.py).
using Fill = void (Simulation::*)(std::span<double>) const;
template <Fill fill>
void into(const Simulation& simulation, Numbers& out) {
    (simulation.*fill)({out.mutable_data(), static_cast<std::size_t>(out.size())});
}

py::array_t<std::uint8_t> snapshot(const Simulation& simulation, std::size_t width, std::size_t height,
                                   const std::string& camera) {
    library::Picture picture =
        interruptible([&] { return simulation.snapshot({.width = width, .height = height, .camera = camera}); });
    return array_of(std::move(picture.rgba),
                    {static_cast<py::ssize_t>(picture.height), static_cast<py::ssize_t>(picture.width), 4});
}

}  // namespace

library::Settings settings_of(const py::dict& given) {
    library::Settings settings;
    settings.method = given["method"].cast<std::string>();
    settings.dt = given["dt"].cast<std::optional<double>>();
    settings.precision = given["precision"].cast<std::string>();
    settings.parameters = parameters_of(given["parameters"].cast<std::map<std::string, std::string>>());
    settings.threads = given["threads"].cast<std::size_t>();
    return settings;
}

void add_runs(py::module_& core) {
    core.def("run", &run);
    core.def("read", &read);
    py::class_<Simulation>(core, "Simulation")
        .def(py::init([](const library::Scene& scene, const py::dict& given) {
            return std::make_unique<Simulation>(scene, settings_of(given));
        }))
        .def("advance", [](Simulation& run, std::uint64_t steps) { interruptible([&] { run.advance(steps); }); })
        .def_property_readonly("step", &Simulation::step)
        .def_property_readonly("time", &Simulation::time)
        .def_property_readonly("particles", &Simulation::particles)
        .def_property_readonly("evaluations", &Simulation::evaluations)
        .def_property_readonly("energy", &Simulation::energy)
        .def_property_readonly("energy_error", &Simulation::energy_error)
        .def_property_readonly("divergence", &Simulation::divergence)
        .def_property_readonly("hash", &Simulation::hash)
        .def("positions", &into<&Simulation::positions>)
        .def("velocities", &into<&Simulation::velocities>)
        .def("forces", &into<&Simulation::forces>)
        .def("snapshot", &snapshot);
}

}  // namespace steplab::python
