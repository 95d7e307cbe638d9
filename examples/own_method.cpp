// A method of one's own: Heun's, a slope at the start and one at the end of each step, through the lab's tests of order
// and stability.
#include <cstdio>
#include <steplab/steplab.hpp>

namespace lab = steplab::library;

struct Heun final : lab::Method {
    lab::MethodDescription description() const override { return {.id = "heun", .order = 2, .evaluations = 2}; }
    void step(lab::Motion& motion) const override {
        const double h = motion.dt();
        const auto x = motion.positions(), v = motion.velocities(), x1 = motion.scratch(0), v1 = motion.scratch(1);
        const auto a = motion.accelerations(x, v);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x1[i] = x[i] + h * v[i];
            v1[i] = v[i] + h * a[i];
            x[i] += h / 2 * v[i];
            v[i] += h / 2 * a[i];
        }
        const auto a1 = motion.accelerations(x1, v1);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += h / 2 * v1[i];
            v[i] += h / 2 * a1[i];
        }
    }
};

int main() {
    lab::add_method(std::make_shared<const Heun>());
    const auto limit = lab::limits(lab::Scene::model("rope", {{"c", 1}}), {"heun"}).front();
    const double order = lab::order(lab::Scene::model("chain"), "heun", 10).value();
    const double part = *limit.measured / *limit.theory;
    std::printf("order %.2f, stable up to dt = %.5f s (theory %.5f s)\n", order, *limit.measured, *limit.theory);
    return order > 1.9 && order < 2.1 && part > 0.99 && part < 1.01 ? 0 : 1;
}
