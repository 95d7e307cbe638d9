// A pair force of one's own: Buckingham's potential between atoms, and that methods keep their order on it.
#include <cmath>
#include <cstdio>
#include <steplab/steplab.hpp>

namespace lab = steplab::library;

int main() {
    const auto r = lab::Expression::named("r"), A = lab::Expression::named("A"), C = lab::Expression::named("C");
    const lab::Expression buckingham = A * exp(-r / 0.3) - C / pow(r, 6);

    const lab::Particles atoms{.positions = {0, 0, 0, 1.3, 0, 0, 0.6, 1.2, 0}, .masses = {1, 1, 2}};
    const auto gas = lab::Scene::of(atoms).with_pair_force(
        lab::PairForce{.potential = buckingham.text(), .values = {{"A", 100}, {"C", 1}}});

    bool kept = true;
    for (const auto& [method, order] : {std::pair("velocity-verlet", 2), std::pair("rk4", 4)}) {
        const double measured = lab::order(gas, method, 2).value();
        std::printf("%-16s order %.2f\n", method, measured);
        kept = kept && std::abs(measured - order) < 0.15;
    }
    const auto limit = lab::limits(gas, {"velocity-verlet"}).front();
    std::printf("velocity-verlet is stable up to dt = %.4f s (theory %.4f s)\n", *limit.measured, *limit.theory);
    return kept && std::abs(*limit.measured / *limit.theory - 1) < 0.01 ? 0 : 1;
}
