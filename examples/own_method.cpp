// A method of one's own: Heun's, a slope at the start and one at the end of each step, through the lab's tests of order
// and stability.
#include <cmath>
#include <cstdio>
#include <steplab/steplab.hpp>

namespace lab = steplab::library;

class Heun final : public lab::Method {
public:
    lab::MethodDescription description() const override {
        return {.id = "heun", .name = "Heun", .order = 2, .order_with_drag = 2, .evaluations = 2};
    }
    void step(lab::Motion& motion) const override {
        const double h = motion.dt();
        const auto x = motion.positions(), v = motion.velocities(), slope = motion.scratch(0);
        const auto x1 = motion.scratch(1), v1 = motion.scratch(2);
        const auto a = motion.accelerations(x, v);
        for (std::size_t i = 0; i < x.size(); ++i) {
            slope[i] = a[i];
            x1[i] = x[i] + h * v[i];
            v1[i] = v[i] + h * a[i];
        }
        const auto a1 = motion.accelerations(x1, v1);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += h / 2 * (v[i] + v1[i]);
            v[i] += h / 2 * (slope[i] + a1[i]);
        }
    }
};

int main() {
    lab::add_method(std::make_shared<const Heun>());
    const auto rope = lab::Scene::model("rope", {{"c", 1}});
    const auto limit = lab::limits(rope, {"heun"}).front();
    const double order = lab::order(lab::Scene::model("chain"), "heun", 10).value();
    std::printf("order %.2f, stable up to dt = %.5f s (theory %.5f s)\n", order, *limit.measured, *limit.theory);
    return std::abs(order - 2) < 0.1 && std::abs(*limit.measured / *limit.theory - 1) < 0.01 ? 0 : 1;
}
