#include "models/scene/scene_particles.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace steplab {

namespace {

Vec3 shifted(Vec3 from, std::size_t times, const WrittenVector& step) {
    return from + static_cast<double>(times) * step.value();
}

/// The particles of a cell, in parts of it.
std::vector<Vec3> cell_of(CrystalArrangement::Kind kind) {
    if (kind == CrystalArrangement::Kind::bcc) return {{0, 0, 0}, {0.5, 0.5, 0.5}};
    if (kind == CrystalArrangement::Kind::fcc) return {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
    return {{0, 0, 0}};
}

struct PlaceOf {
    Vec3 from;
    std::size_t index;

    Vec3 operator()(const std::monostate&) const { return from; }
    Vec3 operator()(const LineArrangement& line) const { return shifted(from, index, line.step); }
    Vec3 operator()(const GridArrangement& grid) const {
        return shifted(shifted(from, index % grid.columns, grid.steps[0]), index / grid.columns, grid.steps[1]);
    }
    Vec3 operator()(const CrystalArrangement& crystal) const {
        const std::vector<Vec3> cell = cell_of(crystal.kind);
        const Vec3 within = cell[index % cell.size()];
        const std::size_t number = index / cell.size(), row = number / crystal.cells[0];
        const auto along = [&](std::size_t cells, double part) {
            return (static_cast<double>(cells) + part) * crystal.constant.value;
        };
        return from + Vec3{along(number % crystal.cells[0], within.x), along(row % crystal.cells[1], within.y),
                           along(row / crystal.cells[1], within.z)};
    }
    Vec3 operator()(const ListedParticles& list) const { return from + (*list.particles)[index].position; }
};

std::size_t product(std::size_t a, std::size_t b) {
    std::size_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) throw UsageError("there are more particles than any computer holds");
    return result;
}

struct Count {
    std::size_t operator()(const std::monostate&) const { return 1; }
    std::size_t operator()(const LineArrangement& line) const { return line.count; }
    std::size_t operator()(const GridArrangement& grid) const { return product(grid.columns, grid.rows); }
    std::size_t operator()(const CrystalArrangement& crystal) const {
        const auto& [x, y, z] = crystal.cells;
        return product(product(product(x, y), z), cell_of(crystal.kind).size());
    }
    std::size_t operator()(const ListedParticles& list) const { return list.particles->size(); }
};

std::optional<long> whole(std::string_view text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// "2-5" as 2 and 5; a number alone stands for both. The hyphen is not the sign of the first.
std::optional<std::pair<long, long>> whole_range(std::string_view text) {
    const std::size_t hyphen = text.find('-', 1);
    const auto first = whole(text.substr(0, hyphen));
    const auto last = hyphen == std::string_view::npos ? first : whole(text.substr(hyphen + 1));
    if (!first || !last) return std::nullopt;
    return std::pair{*first, *last};
}

/// Negative numbers count from the end. Throws UsageError.
std::size_t counted(long number, std::size_t count, std::string_view what) {
    const auto all = static_cast<long>(count);
    if (number >= -all && number < all) return static_cast<std::size_t>(number < 0 ? number + all : number);
    throw UsageError(fmt::format("{} has no particle {}: they count from 0 to {}", what, number, all - 1));
}

/// Fixed particles and no others have the role of one.
Role role_of(const SceneParticle& particle) {
    if (particle.fixed) return Role::fixed;
    return particle.role == Role::fixed ? Role::moving : particle.role;
}

/// What a file says of a particle beside its place.
void apply(const ListedParticles& list, std::size_t index, SceneParticle& particle) {
    const ListedParticles::Particle& listed = (*list.particles)[index];
    particle.velocity = particle.velocity + listed.velocity;
    if (list.masses) particle.mass = listed.mass;
    if (!list.roles) return;
    particle.role = listed.role;
    particle.fixed = listed.role == Role::fixed;
}

}  // namespace

std::size_t ParticleBlock::count() const { return std::visit(Count(), arrangement); }

std::size_t Scene::count() const {
    std::size_t sum = 0;
    for (const ParticleBlock& block : particles) {
        if (__builtin_add_overflow(sum, block.count(), &sum))
            throw UsageError("there are more particles than any computer holds");
    }
    return sum;
}

SceneParticles::SceneParticles(const Scene& scene, Ask ask) : count_(scene.count()) {
    std::size_t first = 0;
    for (const ParticleBlock& block : scene.particles) {
        if (!block.group.empty()) groups_.try_emplace(block.group, blocks_.size());
        Block& added = blocks_.emplace_back(Block{&block, first, block.count(), {}});
        if (block.temperature && ask == Ask::all)
            added.thermal.emplace(*block.temperature, block.mass.value, added.count);
        first += added.count;
    }
    if (ask == Ask::names) return;
    for (const Fix& fix : scene.fixes) {
        for (const std::string& text : fix.particles) add(fix, named(text));
    }
}

void SceneParticles::add(const Fix& fix, IndexRange range) {
    if (fix.fixed) fixed_.give(range, *fix.fixed);
    if (fix.velocity) velocities_.give(range, *fix.velocity);
    if (fix.displacement) displacements_.give(range, *fix.displacement);
    if (fix.mass) masses_.give(range, *fix.mass);
    if (fix.charge) charges_.give(range, *fix.charge);
    if (fix.role) roles_.give(range, *fix.role);
}

void SceneParticles::apply_fixes(std::size_t i, SceneParticle& particle) const {
    if (const bool* const fixed = fixed_.at(i)) particle.fixed = *fixed;
    if (const WrittenVector* const velocity = velocities_.at(i)) particle.velocity = velocity->value();
    if (const WrittenVector* const displacement = displacements_.at(i)) particle.displacement = displacement->value();
    if (const WrittenNumber* const mass = masses_.at(i)) particle.mass = mass->value;
    if (const WrittenNumber* const charge = charges_.at(i)) particle.charge = charge->value;
    if (const Role* const role = roles_.at(i)) particle.role = *role;
}

SceneParticle SceneParticles::operator[](std::size_t i) const {
    const auto after =
        std::upper_bound(blocks_.begin(), blocks_.end(), i, [](std::size_t n, const Block& b) { return n < b.first; });
    const Block& block = *std::prev(after);
    SceneParticle particle = of_block(block, i - block.first);
    apply_fixes(i, particle);
    if (particle.fixed) particle.velocity = {};
    particle.role = role_of(particle);
    return particle;
}

SceneParticle SceneParticles::of_block(const Block& block, std::size_t index) const {
    const ParticleBlock& of = *block.block;
    SceneParticle particle{.position = std::visit(PlaceOf{of.position.value(), index}, of.arrangement),
                           .displacement = {},
                           .velocity = of.velocity.value(),
                           .mass = of.mass.value,
                           .charge = of.charge.value,
                           .fixed = of.fixed,
                           .role = of.role};
    if (const auto* list = std::get_if<ListedParticles>(&of.arrangement)) apply(*list, index, particle);
    if (const auto* vector = std::get_if<WrittenVector>(&of.displacement)) particle.displacement = vector->value();
    if (const auto* random = std::get_if<RandomDisplacement>(&of.displacement))
        particle.displacement = random_displacement(*random, index);
    if (block.thermal) particle.velocity = particle.velocity + (*block.thermal)[index];
    return particle;
}

SceneParticles::Group SceneParticles::group(std::string_view name) const {
    if (const auto known = groups_.find(name); known != groups_.end()) {
        const Block& block = blocks_[known->second];
        return {*block.block, {block.first, block.count}};
    }
    std::vector<std::string_view> known;
    for (const Block& block : blocks_) {
        if (!block.block->group.empty()) known.push_back(block.block->group);
    }
    throw UsageError(unknown_word("group", name, known));
}

IndexRange SceneParticles::named(std::string_view text) const {
    if (text == "all") return {0, count_};
    const std::size_t bracket = text.find('[');
    if (bracket == std::string_view::npos) {
        const auto numbers = whole_range(text);
        if (!numbers) return group(text).particles;
        const std::size_t first = counted(numbers->first, count_, "the scene"),
                          last = counted(numbers->second, count_, "the scene");
        if (last < first) throw UsageError(fmt::format("'{}' ends before it begins", shown(text)));
        return {first, last - first + 1};
    }
    if (!text.ends_with(']')) throw UsageError(fmt::format("'{}' lacks a closing bracket", shown(text)));
    const Group of = group(text.substr(0, bracket));
    const std::string_view inside = text.substr(bracket + 1, text.size() - bracket - 2);
    if (inside.find(',') != std::string_view::npos) return {of.particles.first + index_in(inside, of), 1};
    const auto numbers = whole_range(inside);
    if (!numbers) throw UsageError(fmt::format("'{}': a number belongs into the brackets", shown(text)));
    const std::string name = fmt::format("group '{}'", shown(of.block.group));
    const std::size_t first = counted(numbers->first, of.particles.count, name),
                      last = counted(numbers->second, of.particles.count, name);
    if (last < first) throw UsageError(fmt::format("'{}' ends before it begins", shown(text)));
    return {of.particles.first + first, last - first + 1};
}

std::size_t SceneParticles::index_in(std::string_view text, const Group& group) const {
    const auto* grid = std::get_if<GridArrangement>(&group.block.arrangement);
    const std::string name = fmt::format("group '{}'", shown(group.block.group));
    if (!grid) throw UsageError(name + " is no grid: one number belongs into the brackets");
    const std::size_t comma = text.find(',');
    const auto begin = text.find_first_not_of(' ', comma + 1);
    const auto i = whole(text.substr(0, comma)), j = whole(begin == std::string_view::npos ? "" : text.substr(begin));
    if (!i || !j)
        throw UsageError(
            fmt::format("'{}[{}]': two numbers belong into the brackets", shown(group.block.group), shown(text)));
    return counted(*j, grid->rows, name) * grid->columns + counted(*i, grid->columns, name);
}

std::optional<double> common_mass(const SceneParticles& particles) {
    const double mass = particles[0].mass;
    for (std::size_t i = 1; i < particles.count(); ++i) {
        if (particles[i].mass != mass) return std::nullopt;
    }
    return mass;
}

}  // namespace steplab
