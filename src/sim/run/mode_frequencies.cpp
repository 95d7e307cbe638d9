#include "sim/run/mode_frequencies.hpp"

#include "sim/run/linearised.hpp"
#include "sim/run/starting.hpp"

#include <cmath>
#include <cstddef>

namespace steplab {

std::optional<std::vector<double>> mode_frequencies(const RunDescription& description, std::size_t most) {
    Plan plan = plan_of(description);
    if (plan.reference.count > most) return std::nullopt;
    const Shape shape = model_of(description).shape(description.scene);
    plan.start = {plan.reference.count, [&shape, reference = plan.reference](std::size_t i) {
                      return Start::Particle{shape.rest[i] - reference.at(i), {}};
                  }};
    const Eigen::VectorXd values = all_modes({plan, shape}).values;
    std::vector<double> frequencies;
    for (Eigen::Index k = count_of_still(values); k < values.size(); ++k) frequencies.push_back(std::sqrt(values[k]));
    return frequencies;
}

}  // namespace steplab
