#include "io/listed_blocks.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// A scene file with as many blocks is read within some seconds.
constexpr std::size_t most_blocks = 100'000;

bool is_number(const WrittenVector& v) { return v.x.text.empty() && v.y.text.empty() && v.z.text.empty(); }

/// True if this selects from the group: "gas" or "gas[2-5]".
bool selects(std::string_view selection, std::string_view group) {
    return !group.empty() && selection.substr(0, selection.find('[')) == group;
}
bool selects(const std::vector<std::string>& selections, std::string_view group) {
    return std::any_of(selections.begin(), selections.end(), [&](const auto& each) { return selects(each, group); });
}

/// True if anything of the scene is said of the group.
bool uses(const Scene& scene, std::string_view group) {
    const auto any = [](const auto& terms, const auto& does) { return std::any_of(terms.begin(), terms.end(), does); };
    return any(scene.fixes, [&](const Fix& fix) { return selects(fix.particles, group); }) ||
           any(scene.pairs, [&](const PairTerm& term) { return selects(term.between, group); }) ||
           any(scene.fields, [&](const FieldTerm& field) { return selects(field.particles, group); }) ||
           any(scene.springs, [&](const SpringTerm& term) {
               return selects(term.between, group) || any(term.pairs, [&](const auto& ends) {
                          return selects(ends.first, group) || selects(ends.second, group);
                      });
           });
}

/// Why particles cannot leave their block; empty if they can.
std::string_view why_together(const Scene& scene, const ParticleBlock& block) {
    if (uses(scene, block.group)) return "as the group that other parts of the scene name";
    if (block.temperature) return "together, for the temperature of their block";
    if (std::holds_alternative<RandomDisplacement>(block.displacement))
        return "together, for the random displacements of their block";
    if (!is_number(block.position) || !is_number(block.velocity))
        return "together, for the parameters in their position or velocity";
    return {};
}

WrittenVector written(Vec3 v) { return {v.x, v.y, v.z}; }

/// A particle of the list in a block that has all else of the list's block.
ParticleBlock block_of(ParticleBlock block, const ListedParticles& list, const ListedParticles::Particle& particle) {
    block.group.clear();
    block.arrangement = std::monostate();
    block.position = written(block.position.value() + particle.position);
    block.velocity = written(block.velocity.value() + particle.velocity);
    if (list.masses) block.mass = particle.mass;
    if (list.roles) block.role = particle.role;
    if (list.roles) block.fixed = particle.role == Role::fixed;
    return block;
}

}  // namespace

Scene without_files(Scene scene) {
    if (!scene.start.file.empty())
        throw UsageError(
            fmt::format("the scene reads its start from '{}': its text alone cannot hold it", shown(scene.start.file)));
    std::vector<ParticleBlock> blocks;
    for (const ParticleBlock& block : scene.particles) {
        const auto* const list = std::get_if<ListedParticles>(&block.arrangement);
        if (!list) {
            blocks.push_back(block);
            continue;
        }
        if (const std::string_view why = why_together(scene, block); !why.empty())
            throw UsageError(fmt::format("the scene needs the particles of '{}' {}: its text alone cannot hold them",
                                         shown(list->file), why));
        if (blocks.size() + list->particles->size() > most_blocks)
            throw UsageError(fmt::format("the text of a scene holds at most {} particles one by one, but '{}' has {}",
                                         most_blocks, shown(list->file), list->particles->size()));
        for (const auto& particle : *list->particles) blocks.push_back(block_of(block, *list, particle));
    }
    scene.particles = std::move(blocks);
    return scene;
}

}  // namespace steplab
