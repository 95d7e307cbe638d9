#pragma once

#include "core/field.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace steplab {

/// The initial displacement and velocity of every particle. They may be given by a function, so that a large scene
/// needs no memory for them.
class Start {
public:
    struct Particle {
        Vec3 displacement, velocity;
    };

    Start() = default;
    Start(std::size_t count, std::function<Particle(std::size_t)> rule) : count_(count), rule_(std::move(rule)) {}
    explicit(false) Start(State<double> state)
        : count_(state.displacement.count()), held_(std::make_shared<const State<double>>(std::move(state))) {}
    /// At rest in the reference positions, except for one particle.
    static Start kick(std::size_t count, std::size_t kicked, Vec3 velocity) {
        return {count, [=](std::size_t i) { return Particle{{}, i == kicked ? velocity : Vec3{}}; }};
    }

    std::size_t count() const { return count_; }
    Particle operator[](std::size_t i) const {
        if (held_) return {held_->displacement.at(first_ + i), held_->velocity.at(first_ + i)};
        return rule_(first_ + i);
    }

    /// The start of the `count` particles from `first`.
    Start part(std::size_t first, std::size_t count) const {
        Start part = *this;
        part.first_ += first;
        part.count_ = count;
        return part;
    }

    /// The whole start in this number type, each number rounded once.
    template <class T = double>
    State<T> state() const {
        if (held_ && count_ == held_->displacement.count())
            return {converted<T>(held_->displacement), converted<T>(held_->velocity)};
        State<T> state{Field<T>(count_), Field<T>(count_)};
        for (std::size_t i = 0; i < count_; ++i) {
            const Particle particle = (*this)[i];
            state.displacement.set(i, particle.displacement);
            state.velocity.set(i, particle.velocity);
        }
        return state;
    }

private:
    std::size_t count_ = 0;
    std::size_t first_ = 0;  ///< index of particle 0 in the function or the state
    std::function<Particle(std::size_t)> rule_;
    std::shared_ptr<const State<double>> held_;
};

}  // namespace steplab
