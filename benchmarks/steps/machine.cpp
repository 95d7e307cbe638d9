#include "machine.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <memory>
#include <vector>

namespace steplab::benchmark {
namespace {

template <class T>
struct Numbers {
    std::vector<T> x, y;
    explicit Numbers(std::size_t count) : x(count, T(1.5)), y(count, T(0)) {}
};

/// `pass(x, y, count)` again and again.
template <class T, class Pass>
Contestant passes(std::size_t count, Pass pass) {
    return {"machine", [=] {
                auto numbers = std::make_shared<Numbers<T>>(count);
                return Stepping{[=](std::size_t steps) {
                                    for (std::size_t s = 0; s < steps; ++s) {
                                        pass(numbers->x.data(), numbers->y.data(), count);
                                        ::benchmark::ClobberMemory();
                                    }
                                },
                                {}};
            }};
}

template <class T>
void roots_and_quotients(const T* __restrict x, T* __restrict y, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) y[k] = T(1) / std::sqrt(x[k]);
}

template <class T>
void multiply_and_add(const T* __restrict x, T* __restrict y, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) y[k] += T(0.5) * x[k];
}

constexpr std::size_t batch = std::size_t(1) << 24;  // numbers

template <class T>
Comparison springs(const std::string& precision) {
    const std::size_t few = 1024;
    return {"machine-springs/-/" + precision, few, {{passes<T>(few, roots_and_quotients<T>), batch / few}}};
}

Comparison memory(std::size_t bytes) {
    const std::size_t count = bytes / (2 * sizeof(double));
    return {"machine-memory/-/double",
            count,
            {{passes<double>(count, multiply_and_add<double>), std::max<std::size_t>(2, batch / count)}}};
}

}  // namespace

std::vector<Comparison> machine_comparisons() {
    std::vector<Comparison> all{springs<double>("double"), springs<float>("float")};
    for (const std::size_t kibibytes : {32U, 512U, 8U << 10, 512U << 10}) all.push_back(memory(kibibytes << 10));
    return all;
}

}  // namespace steplab::benchmark
