#include "core/processor.hpp"

#include <iostream>

// Prints the best instruction set of this processor, for STEPLAB_INSTRUCTION_SETS=native.

int main() {
    using steplab::Instructions;
    const char* best = "baseline";
    if (steplab::processor_has(Instructions::avx2)) best = "avx2";
    if (steplab::processor_has(Instructions::avx512)) best = "avx512";
    std::cout << best;
}
