#pragma once

// Vectors of C++ as arrays of NumPy and back.

#include <cstddef>
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <span>
#include <utility>
#include <vector>

namespace steplab::python {

namespace py = pybind11;

/// The numbers as an array of this shape, which takes over their memory: nothing is copied.
template <class Number>
py::array_t<Number> array_of(std::vector<Number> numbers, std::vector<py::ssize_t> shape) {
    auto held = std::make_unique<std::vector<Number>>(std::move(numbers));
    Number* const first = held->data();
    const py::capsule owner(held.get(), [](void* vector) { delete static_cast<std::vector<Number>*>(vector); });
    held.release();
    return py::array_t<Number>(std::move(shape), first, owner);
}

/// The same in one row.
template <class Number>
py::array_t<Number> array_of(std::vector<Number> numbers) {
    const auto count = static_cast<py::ssize_t>(numbers.size());
    return array_of(std::move(numbers), {count});
}

/// An array that was checked to be contiguous (_arrays.py).
using Numbers = py::array_t<double, py::array::c_style>;

inline std::span<const double> span_of(const Numbers& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

}  // namespace steplab::python
