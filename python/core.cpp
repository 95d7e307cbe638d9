// The module steplab._core: the library of include/steplab for the Python of python/steplab, which is what people use.

#include "core.hpp"

#include "arrays.hpp"

#include <new>
#include <pybind11/stl.h>
#include <stdexcept>
#include <steplab/steplab.hpp>
#include <string_view>

namespace steplab::python {

namespace {

namespace library = steplab::library;

/// Of a message with bytes that are no UTF-8, as names of files may have them, these are replaced.
void raise(const char* name, std::string_view message) {
    const py::object type = py::module_::import("steplab._errors").attr(name);
    const auto size = static_cast<py::ssize_t>(message.size());
    const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(message.data(), size, "replace"));
    PyErr_SetObject(type.ptr(), text.ptr());
}

/// Exceptions of the library as those of the same name in _errors.py.
void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const library::UsageError& error) {
        raise("UsageError", error.what());
    } catch (const library::FileError& error) {
        raise("FileError", error.what());
    } catch (const library::Diverged& error) {
        raise("Diverged", error.what());
    } catch (const library::GraphicsError& error) {
        raise("GraphicsError", error.what());
    } catch (const library::Error& error) {
        raise("Error", error.what());
    } catch (const std::bad_alloc&) {
        raise("UsageError", "not enough memory");
    } catch (const std::length_error&) {
        raise("UsageError", "not enough memory: more than any array can hold");
    }
}

/// As os.fsdecode() has it.
py::str text_of_file_name(const std::string& name) {
    const auto size = static_cast<py::ssize_t>(name.size());
    return py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefaultAndSize(name.data(), size));
}

py::dict arrays_of(library::Particles particles) {
    const auto count = static_cast<py::ssize_t>(particles.positions.size() / 3);
    py::dict arrays;
    arrays["positions"] = array_of(std::move(particles.positions), {count, 3});
    arrays["velocities"] = array_of(std::move(particles.velocities), {count, 3});
    arrays["masses"] = array_of(std::move(particles.masses));
    return arrays;
}

std::vector<double> copied(const Numbers& array) {
    const auto numbers = span_of(array);
    return {numbers.begin(), numbers.end()};
}

library::Scene scene_of_arrays(const Numbers& positions, const std::optional<Numbers>& velocities,
                               const std::optional<Numbers>& masses) {
    const library::Particles particles{.positions = copied(positions),
                                       .velocities = velocities ? copied(*velocities) : std::vector<double>(),
                                       .masses = masses ? copied(*masses) : std::vector<double>()};
    const py::gil_scoped_release others;
    return library::Scene::of(particles);
}

void add_scene(py::module_& core) {
    using library::Scene;
    using Texts = std::map<std::string, std::string>;
    const auto others = py::call_guard<py::gil_scoped_release>();
    py::class_<Scene>(core, "Scene")
        .def_static(
            "model", [](const std::string& id, const Texts& given) { return Scene::model(id, parameters_of(given)); },
            others)
        .def_static(
            "from_file",
            [](const std::string& name, const Texts& given) { return Scene::from_file(name, parameters_of(given)); },
            others)
        .def_static(
            "from_text",
            [](const std::string& text, const Texts& given) { return Scene::from_text(text, parameters_of(given)); },
            others)
        .def_static("restored", &Scene::restored, others)
        .def_static("of", &scene_of_arrays)
        .def(
            "with_parameters",
            [](const Scene& scene, const Texts& given) { return scene.with_parameters(parameters_of(given)); }, others)
        .def(
            "with_force",
            [](const Scene& scene, const std::string& potential, const Texts& values, std::optional<double> cutoff) {
                return scene.with_pair_force(library::PairForce{potential, parameters_of(values), cutoff});
            },
            others)
        .def("starting_at",
             [](const Scene& scene, const Numbers& positions, const Numbers& velocities) {
                 const auto x = span_of(positions), v = span_of(velocities);
                 const py::gil_scoped_release released;
                 return scene.starting_at(x, v);
             })
        .def_property_readonly("name", [](const Scene& scene) { return text_of_file_name(scene.name()); })
        .def_property_readonly("particles", &Scene::particles)
        .def_property_readonly("parameters", [](const Scene& scene) { return texts_of(scene.parameters()); })
        .def("start", [](const Scene& scene) { return arrays_of(scene.start()); })
        .def("text", &Scene::text, others)
        .def("saved", &Scene::saved, others);
}

}  // namespace

library::Parameters parameters_of(const std::map<std::string, std::string>& texts) {
    library::Parameters parameters;
    for (const auto& [name, text] : texts) parameters.emplace(name, library::Value(text));
    return parameters;
}

std::map<std::string, std::string> texts_of(const library::Parameters& parameters) {
    std::map<std::string, std::string> texts;
    for (const auto& [name, value] : parameters) texts.emplace(name, value.text());
    return texts;
}

}  // namespace steplab::python

PYBIND11_MODULE(_core, core) {
    using namespace steplab::python;
    core.doc() = "What steplab computes; use the module steplab.";
    py::register_exception_translator(&translate);
    core.attr("version") = std::string(steplab::library::version());
    core.def("models", &steplab::library::models);
    core.def("methods", &steplab::library::methods);
    core.def("scenes", &steplab::library::scenes);
    add_scene(core);
    add_runs(core);
    add_lab(core);
}
