#include "models/conservation.hpp"

#include "models/outer_forces.hpp"

#include <algorithm>
#include <variant>
#include <vector>

namespace steplab {

namespace {

/// Where a particle is at the start: fixed ones stay there.
Vec3 start_of(const Plan& scene, std::size_t i) { return scene.reference.at(i) + scene.start[i].displacement; }

bool is_fixed(const Composition& terms, std::size_t i) { return !terms.fixed.empty() && terms.fixed[i] != 0; }

/// The fixed particles that act on others.
class Anchors {
public:
    explicit Anchors(const Composition& terms) : terms_(terms), holds_(terms.count) {
        if (terms.fixed.empty()) return;
        for (const ComposedSpring& spring : terms.springs) {
            note(spring.first, spring.second);
            note(spring.second, spring.first);
        }
        for (const ComposedPairs& pairs : terms.pairs) {
            for (const auto& [one, other] : pairs.listed) {
                note(one, other);
                note(other, one);
            }
            if (!pairs.listed.empty()) continue;
            const auto& others = pairs.second.empty() ? pairs.first : pairs.second;
            note(pairs.first, others);
            note(others, pairs.first);
        }
    }
    std::vector<std::size_t> all() const {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < holds_.size(); ++i) {
            if (holds_[i]) all.push_back(i);
        }
        return all;
    }

private:
    void note(std::size_t one, std::size_t other) {
        if (is_fixed(terms_, one) && !is_fixed(terms_, other)) holds_[one] = true;
    }
    void note(const std::vector<std::uint32_t>& some, const std::vector<std::uint32_t>& others) {
        const auto moves = [&](std::uint32_t i) { return !is_fixed(terms_, i); };
        if (std::none_of(others.begin(), others.end(), moves)) return;
        for (const std::uint32_t i : some) holds_[i] = holds_[i] || is_fixed(terms_, i);
    }

    const Composition& terms_;
    std::vector<bool> holds_;
};

/// What changes the sums of a scene, each cause by itself.
struct Changes {
    const Plan& scene;

    Conservation operator()(const ConstantForces& forces) const {
        if (forces.step == 0 || forces.count < 2) return {};  // particle 0 is not accelerated
        return {.momentum = false, .angular_momentum = false, .cause = "constant forces"};
    }
    Conservation operator()(const LineForces& forces) const {
        if (forces.gravity != 0) return {.momentum = false, .angular_momentum = false, .cause = "gravity"};
        return forces.first_fixed ? anchored({0}) : Conservation();
    }
    Conservation operator()(const GridForces&) const {
        return {.momentum = false, .angular_momentum = false, .cause = "fixed particles"};
    }
    Conservation operator()(const PairForces&) const { return {}; }
    /// A force across the border of the box acts along the line to an image.
    Conservation operator()(const NearPairForces& forces) const {
        if (forces.period > 0) return {.angular_momentum = false, .cause = "periodic boundary conditions"};
        return {};
    }
    Conservation operator()(const ComposedForces& forces) const {
        const Composition& terms = *forces.terms;
        Conservation kept;
        const auto add = [&](const Conservation& changed) {
            if (kept.cause.empty() || (kept.momentum && !changed.momentum)) kept.cause = changed.cause;
            kept.energy = kept.energy && changed.energy;
            kept.momentum = kept.momentum && changed.momentum;
            kept.angular_momentum = kept.angular_momentum && changed.angular_momentum;
        };
        add(dragged(terms));
        add(pulled(terms));
        add(anchored(Anchors(terms).all()));
        const bool interacts = !terms.springs.empty() || !terms.pairs.empty();
        if (terms.box != Vec3{} && interacts) add({.angular_momentum = false, .cause = "periodic boundary conditions"});
        add(damped(terms));
        return kept;
    }

    /// A fixed particle exerts no torque about the origin if it is there.
    Conservation anchored(const std::vector<std::size_t>& anchors) const {
        if (anchors.empty()) return {};
        const bool at_origin =
            std::all_of(anchors.begin(), anchors.end(), [&](std::size_t i) { return start_of(scene, i) == Vec3{}; });
        return {.momentum = false,
                .angular_momentum = at_origin,
                .cause = anchors.size() == 1 ? "a fixed particle" : "fixed particles"};
    }

    static Conservation dragged(const Composition& terms) {
        for (std::size_t i = 0; i < terms.drag.size(); ++i) {
            if (terms.drag[i] > 0 && !is_fixed(terms, i)) return {false, false, false, "drag"};
        }
        return {};
    }

    Conservation pulled(const Composition& terms) const {
        const OuterForces outer = outer_forces(scene, terms);
        return {.momentum = !outer.net, .angular_momentum = outer.central, .cause = outer.cause};
    }

    /// Along the line between its ends and equal for both.
    static Conservation damped(const Composition& terms) {
        const bool any = std::any_of(terms.springs.begin(), terms.springs.end(), [&](const ComposedSpring& spring) {
            return spring.damping > 0 && !(is_fixed(terms, spring.first) && is_fixed(terms, spring.second));
        });
        return any ? Conservation{.energy = false, .cause = "dashpots"} : Conservation();
    }
};

}  // namespace

Conservation conservation(const Plan& scene) {
    if (scene.drag > 0) return {false, false, false, "drag"};
    return std::visit(Changes{scene}, scene.forces);
}

}  // namespace steplab
