#include "libraries.hpp"

namespace steplab::benchmark {

std::vector<Solver> plain_solvers(const Problem& problem) {
    return solvers_of<PlainChain<double>, PlainMesh, PlainMorse>(problem);
}

}  // namespace steplab::benchmark
