#pragma once

#include "force.hpp"

#include <gsl/gsl_errno.h>
#include <nvector/nvector_serial.h>
#include <stdexcept>
#include <string>
#include <sundials/sundials_context.h>

namespace steplab::benchmark {

// What GSL and SUNDIALS call, and what SUNDIALS needs around it.

template <class Loop>
int gsl_rates(double, const double* state, double* rate, void* force) {
    static_cast<const Force<Loop>*>(force)->rates(state, rate);
    return GSL_SUCCESS;
}

template <class Loop>
int sundials_rates(realtype, N_Vector state, N_Vector rate, void* force) {
    static_cast<const Force<Loop>*>(force)->rates(N_VGetArrayPointer(state), N_VGetArrayPointer(rate));
    return 0;
}

struct SundialsContext {
    SUNContext context = nullptr;
    SundialsContext() { SUNContext_Create(nullptr, &context); }
    ~SundialsContext() { SUNContext_Free(&context); }
    SundialsContext(const SundialsContext&) = delete;
    SundialsContext& operator=(const SundialsContext&) = delete;
};

inline N_Vector vector_over(std::vector<double>& numbers, const SundialsContext& context) {
    return N_VMake_Serial(static_cast<sunindextype>(numbers.size()), numbers.data(), context.context);
}

inline void succeeded(int result) {
    if (result < 0) throw std::runtime_error("SUNDIALS gave up");
}

}  // namespace steplab::benchmark
