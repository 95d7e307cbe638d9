// The lab for Python: what it measures, as dictionaries of which python/steplab/lab.py makes its classes.

#include "arrays.hpp"
#include "core.hpp"
#include "interruptible.hpp"

#include <pybind11/stl.h>
#include <steplab/lab.hpp>
#include <utility>

namespace steplab::python {

namespace {

using Words = std::vector<std::string>;

py::dict dict_of(const library::Limit& limit) {
    py::dict dict;
    dict["method"] = limit.method;
    dict["precision"] = limit.precision;
    dict["omega_max"] = limit.omega_max;
    dict["theory"] = limit.theory;
    dict["measured"] = limit.measured;
    dict["note"] = limit.note;
    return dict;
}

py::dict dict_of(const library::Measurement& run) {
    py::dict dict;
    dict["method"] = run.method;
    dict["precision"] = run.precision;
    dict["dt"] = run.dt;
    dict["parameters"] = texts_of(run.parameters);
    dict["steps"] = run.steps;
    dict["evaluations"] = run.evaluations;
    dict["error"] = run.error;
    dict["energy_error"] = run.energy_error;
    dict["wall_seconds"] = run.wall_seconds;
    dict["status"] = run.status;
    dict["hash"] = run.hash;
    return dict;
}

py::dict dict_of(library::Comparison run) {
    py::dict dict;
    dict["method"] = run.method;
    dict["precision"] = run.precision;
    dict["dt"] = run.dt;
    dict["times"] = array_of(std::move(run.times));
    dict["error"] = array_of(std::move(run.error));
    dict["rms_error"] = array_of(std::move(run.rms_error));
    dict["energy_error"] = array_of(std::move(run.energy_error));
    dict["momentum_error"] = array_of(std::move(run.momentum_error));
    dict["reference_error"] = array_of(std::move(run.reference_error));
    dict["evaluations"] = array_of(std::move(run.evaluations));
    dict["reference"] = run.reference;
    dict["reason"] = run.reason;
    return dict;
}

template <class Entry>
py::list list_of(std::vector<Entry> entries) {
    py::list list;
    for (Entry& entry : entries) list.append(dict_of(std::move(entry)));
    return list;
}

py::list limits(const library::Scene& scene, const Words& methods, const std::string& precision) {
    return list_of(interruptible([&] { return library::limits(scene, methods, precision); }));
}

py::list compare(const library::Scene& scene, const std::vector<py::dict>& given, double until, std::uint64_t samples) {
    std::vector<library::Settings> runs;
    for (const py::dict& each : given) runs.push_back(settings_of(each));
    return list_of(interruptible([&] { return library::compare(scene, runs, until, samples); }));
}

py::list report(const library::Scene& scene, double until, const Words& methods, const Words& precisions, bool quick) {
    return list_of(interruptible([&] { return library::report(scene, until, {methods, precisions, quick}); }));
}

py::dict advise(const library::Scene& scene, double error, double until, const Words& methods, const Words& precisions,
                bool quick) {
    const library::Advice advice = interruptible([&] {
        return library::advise(scene, error, until, {methods, precisions, quick});
    });
    py::dict dict;
    dict["best"] = dict_of(advice.best);
    dict["others"] = list_of(advice.others);
    dict["command"] = advice.command;
    dict["reference"] = advice.reference;
    return dict;
}

std::optional<double> order(const library::Scene& scene, const std::string& method, double until) {
    return interruptible([&] { return library::order(scene, method, until); });
}

}  // namespace

void add_lab(py::module_& core) {
    core.def("limits", &limits);
    core.def("compare", &compare);
    core.def("report", &report);
    core.def("advise", &advise);
    core.def("order", &order);
}

}  // namespace steplab::python
