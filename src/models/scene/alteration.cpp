#include "models/scene/alteration.hpp"

#include "models/scene/planner.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace steplab {

namespace {

/// One that is free again is one like others.
Fix fix_of(const Alteration& alteration) {
    Fix fix{.particles = {}, .fixed = alteration.fixed};
    if (alteration.fixed) fix.role = *alteration.fixed ? Role::fixed : Role::moving;
    if (alteration.mass) fix.mass = *alteration.mass;
    return fix;
}

bool same(const Alteration& a, const Alteration& b) { return a.fixed == b.fixed && a.mass == b.mass; }

std::string range_text(std::size_t first, std::size_t last) {
    return first == last ? std::to_string(first) : fmt::format("{}-{}", first, last);
}

}  // namespace

/// Successive particles that are altered in the same way need one entry.
Scene altered(Scene scene, std::span<const Alteration> alterations) {
    for (std::size_t i = 0; i < alterations.size();) {
        const Alteration& first = alterations[i];
        std::size_t count = 1;
        while (i + count < alterations.size() && same(alterations[i + count], first) &&
               alterations[i + count].particle == first.particle + count)
            ++count;
        Fix fix = fix_of(first);
        fix.particles = {range_text(first.particle, first.particle + count - 1)};
        scene.fixes.push_back(std::move(fix));
        i += count;
    }
    return scene;
}

Shape altered(Shape shape, const Scene& scene) {
    Shape of_scene = shape_of(scene);
    shape.roles = std::move(of_scene.roles);
    shape.masses = std::move(of_scene.masses);
    return shape;
}

}  // namespace steplab
