#pragma once

// Long computations: other threads of Python go on meanwhile, and Ctrl+C ends them.

#include <atomic>
#include <chrono>
#include <future>
#include <pybind11/pybind11.h>
#include <steplab/error.hpp>

namespace steplab::python {

namespace py = pybind11;

/// Does the work on a thread of its own, while this one waits without the lock of the interpreter and handles signals a
/// few times a second: what a handler throws, such as KeyboardInterrupt, ends the work.
template <class Work>
auto interruptible(const Work& work) {
    constexpr std::chrono::milliseconds between_signals{50};
    std::atomic<bool> asked = false;
    auto result = std::async(std::launch::async, [&] {
        const library::Interruption here(asked);
        return work();
    });
    while (true) {
        {
            const py::gil_scoped_release others;
            if (result.wait_for(between_signals) == std::future_status::ready) break;
        }
        if (PyErr_CheckSignals() == 0) continue;
        const py::error_already_set raised;
        asked = true;
        {
            const py::gil_scoped_release others;
            result.wait();
        }
        throw raised;
    }
    return result.get();
}

}  // namespace steplab::python
