#include "libraries.hpp"

namespace steplab::benchmark {

std::vector<Solver> plain_solvers(const Problem& problem) {
    return solvers_of<PlainChain<double>, PlainMesh<double>, PlainMorse<double>, FixedSun<PointsInARow<double>>,
                      PlainPlanets<double>>(problem);
}

}  // namespace steplab::benchmark
