#include "libraries.hpp"

namespace steplab::benchmark {

std::vector<Solver> gather_solvers(const Problem& problem) {
    return solvers_of<GatherChain<double>, GatherMesh<double>, GatherMorse<double>, FixedSun<ComponentsInARow<double>>,
                      GatherPlanets<double>>(problem);
}

}  // namespace steplab::benchmark
