#include "app/library/implementation.hpp"
#include "core/error.hpp"
#include "sim/own_methods.hpp"

#include <steplab/method.hpp>
#include <utility>

namespace steplab::library {

namespace {

/// A method of the public interface, as the rooms below call it.
class PublicSteps final : public OwnSteps {
public:
    explicit PublicSteps(std::shared_ptr<const Method> method) : method_(std::move(method)) {}
    void step(OwnMotion& motion) const override {
        Motion shown(motion);
        method_->step(shown);
    }

private:
    std::shared_ptr<const Method> method_;
};

}  // namespace

double Motion::dt() const { return motion_.dt(); }
std::span<double> Motion::positions() { return motion_.positions(); }
std::span<double> Motion::velocities() { return motion_.velocities(); }
std::span<const double> Motion::accelerations(std::span<const double> positions, std::span<const double> velocities) {
    return motion_.accelerations(positions, velocities);
}
std::span<double> Motion::scratch(std::size_t number) { return motion_.scratch(number); }

Method::~Method() = default;

void add_method(std::shared_ptr<const Method> method) {
    translated([&] {
        if (!method) throw steplab::UsageError("there is no method to add");
        const MethodDescription is = method->description();
        add_own_method({.id = is.id,
                        .name = is.name.empty() ? is.id : is.name,
                        .what = is.what,
                        .order = is.order,
                        .order_with_drag = is.order_with_drag,
                        .evaluations = is.evaluations,
                        .symplectic = is.symplectic,
                        .reversible = is.reversible},
                       std::make_shared<const PublicSteps>(std::move(method)));
    });
}

}  // namespace steplab::library
