#include "libraries.hpp"

namespace steplab::benchmark {

std::vector<Solver> gather_solvers(const Problem& problem) {
    return solvers_of<GatherChain<double>, GatherMesh, GatherMorse>(problem);
}

}  // namespace steplab::benchmark
