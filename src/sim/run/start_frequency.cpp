#include "sim/run/start_frequency.hpp"

#include "core/dual.hpp"
#include "core/field.hpp"
#include "models/forces/layouts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

namespace steplab {

namespace {

using Number = Dual<double>;

double dot(const Field<double>& a, const Field<double>& b) {
    return std::inner_product(a.flat().begin(), a.flat().end(), b.flat().begin(), 0.0);
}

double largest(const Field<double>& field) {
    double largest = 0;
    for (const double number : field.flat()) largest = std::max(largest, std::abs(number));
    return largest;
}

void scale(Field<double>& field, double factor) {
    for (double& number : field.flat()) number *= factor;
}

/// The accelerations at x, and how they change along a direction.
struct Accelerations {
    Field<double> value, change;
};

Accelerations accelerations(const Forces& forces, const Field<double>& x, const Field<double>& along) {
    Field<Number> at = converted<Number>(x), a(x.count());
    for (std::size_t i = 0; i < along.flat().size(); ++i) at.flat()[i].derivative = along.flat()[i];
    std::visit([&](const auto& layout) { engine<Number>(layout).accelerations(at, a); }, forces);
    Accelerations result{Field<double>(x.count()), Field<double>(x.count())};
    for (std::size_t i = 0; i < a.flat().size(); ++i) {
        result.value.flat()[i] = a.flat()[i].value;
        result.change.flat()[i] = a.flat()[i].derivative;
    }
    return result;
}

}  // namespace

double start_frequency(const Plan& scene) {
    const State<double> start = scene.start.state();
    Field<double> motion = start.velocity;
    if (largest(motion) == 0) motion = accelerations(scene.forces, start.displacement, motion).value;
    // its size does not matter; that its squares are numbers does
    if (const double size = largest(motion); size > 0) scale(motion, 1 / size);
    const double size = dot(motion, motion);
    if (!(size > 0)) return 0;
    const double stiffness = -dot(motion, accelerations(scene.forces, start.displacement, motion).change) / size;
    return stiffness > 0 ? std::sqrt(stiffness) : 0;
}

}  // namespace steplab
