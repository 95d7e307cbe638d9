#pragma once

#include "../force.hpp"
#include "core/elementwise.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace steplab::benchmark {

/// The steps as one writes them by hand for one scene: a loop for the force and loops over the arrays.
template <class Loop>
class HandWritten {
public:
    using Number = typename Loop::Number;
    using Numbers = std::vector<Number>;

    HandWritten(Numbers x, Numbers v, Number dt, Loop loop = {})
        : n_(x.size() / 3), dt_(dt), x_(std::move(x)), v_(std::move(v)), loop_(std::move(loop)) {
        for (Numbers* numbers : {&a_, &x1_, &v1_, &dx_, &dv_}) numbers->resize(3 * n_);
        loop_.accelerations(x_.data(), a_.data(), n_);
    }

    void euler() {
        loop_.accelerations(x_.data(), a_.data(), n_);
        each([dt = dt_, x = x_.data(), v = v_.data(), a = a_.data()](std::size_t k) {
            v[k] += dt * a[k];
            x[k] += dt * v[k];
        });
    }

    void velocity_verlet() {
        const Number half = dt_ / 2;
        each([half, dt = dt_, x = x_.data(), v = v_.data(), a = a_.data()](std::size_t k) {
            v[k] += half * a[k];
            x[k] += dt * v[k];
        });
        loop_.accelerations(x_.data(), a_.data(), n_);
        each([half, v = v_.data(), a = a_.data()](std::size_t k) { v[k] += half * a[k]; });
    }

    void midpoint() {
        loop_.accelerations(x_.data(), a_.data(), n_);
        stage(dt_ / 2, v_.data());
        loop_.accelerations(x1_.data(), a_.data(), n_);
        each([dt = dt_, x = x_.data(), v = v_.data(), v1 = v1_.data(), a = a_.data()](std::size_t k) {
            x[k] += dt * v1[k];
            v[k] += dt * a[k];
        });
    }

    void rk4() {
        loop_.accelerations(x_.data(), a_.data(), n_);
        each([dx = dx_.data(), dv = dv_.data(), v = v_.data(), a = a_.data()](std::size_t k) {
            dx[k] = v[k];
            dv[k] = a[k];
        });
        stage(dt_ / 2, v_.data());
        for (const Number step : {dt_ / 2, dt_}) {
            loop_.accelerations(x1_.data(), a_.data(), n_);
            each([dx = dx_.data(), dv = dv_.data(), v1 = v1_.data(), a = a_.data()](std::size_t k) {
                dx[k] += 2 * v1[k];
                dv[k] += 2 * a[k];
            });
            stage(step, v1_.data());
        }
        loop_.accelerations(x1_.data(), a_.data(), n_);
        each([sixth = dt_ / 6, x = x_.data(), v = v_.data(), v1 = v1_.data(), a = a_.data(), dx = dx_.data(),
              dv = dv_.data()](std::size_t k) {
            x[k] += sixth * (dx[k] + v1[k]);
            v[k] += sixth * (dv[k] + a[k]);
        });
    }

private:
    template <class F>
    void each(F f) const {
        elementwise(3 * n_, f);
    }

    /// Where the slope (velocity, a_) leads from the beginning of the step: to x1_, v1_.
    void stage(Number step, const Number* velocity) {
        each([step, velocity, x1 = x1_.data(), v1 = v1_.data(), x = x_.data(), v = v_.data(),
              a = a_.data()](std::size_t k) {
            x1[k] = x[k] + step * velocity[k];
            v1[k] = v[k] + step * a[k];
        });
    }

    std::size_t n_;
    Number dt_;
    Numbers x_, v_;
    Numbers a_;        ///< acceleration of the newest positions
    Numbers x1_, v1_;  ///< a stage
    Numbers dx_, dv_;  ///< sums of slopes
    Loop loop_;
};

}  // namespace steplab::benchmark
