#include "io/frame_block.hpp"

#include "core/flush_subnormals.hpp"

namespace steplab {

FileScene scene_of(const Frame& frame) {
    return {.precision = frame.precision,
            .reference = frame.reference,
            .mass = frame.mass,
            .box = frame.shape->box,
            .corner = frame.shape->corner,
            .cell = frame.cell};
}

std::optional<Role> parse_role(std::string_view name) {
    for (const Role role : {Role::moving, Role::fixed, Role::kicked, Role::bullet}) {
        if (id(role) == name) return role;
    }
    return std::nullopt;
}

std::size_t FrameBlock::rows_of(const Frame& frame, const ParticleChoice& particles) {
    return particles ? particles->size() : frame.velocities.size();
}

void FrameBlock::append(const Frame& frame, const FrameParts& wanted, const ParticleChoice& chosen, std::size_t first,
                        std::size_t count) {
    const auto copy = [&](const auto& from, auto& to) {
        if (chosen) {
            for (std::size_t row = first; row < first + count; ++row) to.push_back(from[(*chosen)[row]]);
        } else {
            const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
            to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
        }
    };
    if (moments.empty()) {
        scene = scene_of(frame);
        frame_rows = rows_of(frame, chosen);
        first_row = first;
        rows = count;
        if (chosen) {
            const auto begin = chosen->begin() + static_cast<std::ptrdiff_t>(first);
            particles.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
        }
        if (!frame.shape->roles.empty()) copy(frame.shape->roles, roles);
        if (!frame.shape->masses.empty()) copy(frame.shape->masses, masses);
    }
    moments.push_back({frame.step, frame.time});
    if (wanted.positions) copy(frame.positions, positions);
    if (wanted.displacements) copy(frame.displacements, displacements);
    copy(frame.velocities, velocities);
}

void FrameBlock::complete(const FrameParts& wanted) {
    if (!wanted.positions || !positions.empty() || displacements.empty() || !scene.reference) return;
    const FlushSubnormals flush;  // as in a run
    positions.reserve(displacements.size());
    for (std::size_t moment = 0; moment < moments.size(); ++moment) {
        for (std::size_t row = 0; row < rows; ++row) {
            const Vec3 displacement = displacements[moment * rows + row];
            positions.push_back(position_of(scene.reference->at(particle(row)), displacement, scene.precision));
        }
    }
}

}  // namespace steplab
