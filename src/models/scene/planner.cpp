#include "models/scene/planner.hpp"

#include "core/error.hpp"
#include "models/scene/composer.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace steplab {

namespace {

/// A scene and its particles, kept together for what is computed from it later.
struct Held {
    explicit Held(const Scene& of) : scene(of), particles(scene) {}
    Scene scene;
    SceneParticles particles;
};

/// Starts at position + displacement, counted from reference positions that are the positions, or the origin.
Start start_of(const std::shared_ptr<const Held>& held, bool from_positions) {
    return {held->particles.count(), [held, from_positions](std::size_t i) {
                const SceneParticle particle = held->particles[i];
                const Vec3 displacement =
                    from_positions ? particle.displacement : particle.position + particle.displacement;
                return Start::Particle{displacement, particle.velocity};
            }};
}

/// What acts on all particles alike from outside; nothing where it does not.
struct Outside {
    Vec3 gravity;
    double drag = 0;
};
std::optional<Outside> outside(const Scene& scene) {
    Outside sum;
    for (const FieldTerm& field : scene.fields) {
        const bool on_all = field.particles.empty() || field.particles == std::vector<std::string>{"all"};
        if (!on_all || !field.potential.empty()) return std::nullopt;
        if (field.gravity) sum.gravity = sum.gravity + field.gravity->value();
        if (field.drag) sum.drag += field.drag->value;
    }
    return sum;
}

bool is_open(const Scene& scene) {
    const Vec3 box = scene.box.value();
    return box.x == 0 && box.y == 0 && box.z == 0;
}

bool is_linear(const SpringTerm& term) {
    return term.damping.value == 0 && term.quadratic.value == 0 && term.cubic.value == 0 && !term.potential;
}

std::unique_ptr<Plan> made(double mass, double drag, const Forces& forces, const Lattice& reference, Start start) {
    auto plan = std::make_unique<Plan>();
    plan->mass = mass;
    plan->drag = drag / mass;
    plan->forces = forces;
    plan->reference = reference;
    plan->start = std::move(start);
    return plan;
}

// A line of equal springs along x, its first particle at the origin and fixed or not.

bool is_on_line(const SceneParticles& particles, double step) {
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const SceneParticle particle = particles[i];
        const Vec3 at = particle.position;
        if (at.x != static_cast<double>(i) * step || at.y != 0 || at.z != 0 || (i > 0 && particle.fixed)) return false;
    }
    return true;
}

/// The force constant of springs that join each particle with the next.
std::optional<double> line_springs(const Scene& scene, const SceneParticles& particles, double step) {
    std::size_t next = 0;
    bool all = true;
    for (const SpringTerm& term : scene.springs) {
        all = all && is_linear(term) && term.k == scene.springs.front().k;
        all = all && (!term.length || term.length->value == step);
        if (!all) return std::nullopt;
        each_spring(particles, term, [&](const ScenePair& pair) {
            all = all && pair.first == next && pair.second == next + 1;
            ++next;
        });
    }
    if (!all || next + 1 != particles.count() || next == 0) return std::nullopt;
    return scene.springs.front().k.value;
}

std::unique_ptr<Plan> as_line(const std::shared_ptr<const Held>& held, double mass) {
    const auto& [scene, particles] = *held;
    const auto outer = outside(scene);
    if (!scene.pairs.empty() || scene.springs.empty() || !is_open(scene) || !outer) return nullptr;
    if (outer->gravity.x != 0 || outer->gravity.z != 0 || particles.count() < 2) return nullptr;
    const double step = particles[1].position.x;
    if (!(step >= 0) || !is_on_line(particles, step)) return nullptr;
    const auto k = line_springs(scene, particles, step);
    if (!k) return nullptr;
    const LineForces forces{.count = particles.count(),
                            .first_fixed = particles[0].fixed,
                            .mass = mass,
                            .k = *k,
                            .rest_length = step,
                            .gravity = outer->gravity.y == 0 ? 0 : -outer->gravity.y};
    return made(mass, outer->drag, forces, {particles.count(), particles.count(), {step, 0, 0}, {}, {}},
                start_of(held, true));
}

// A grid of equal springs in the xz plane, its border fixed.

bool is_on_grid(const SceneParticles& particles, const GridArrangement& grid, double step) {
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const std::size_t row = i / grid.columns, column = i % grid.columns;
        const bool border = row == 0 || column == 0 || row + 1 == grid.rows || column + 1 == grid.columns;
        const SceneParticle particle = particles[i];
        const Vec3 at = particle.position;
        if (at.x != static_cast<double>(column) * step || at.y != 0 || at.z != static_cast<double>(row) * -step ||
            particle.fixed != border)
            return false;
    }
    return true;
}

/// The force constant of springs along the axes and the diagonals of the grid.
std::optional<double> grid_springs(const Scene& scene, double step) {
    using Along = SpringTerm::Along;
    int axes = 0, diagonals = 0;
    for (const SpringTerm& term : scene.springs) {
        const double diagonal = std::numbers::sqrt2 * step;
        const bool usual_length = !term.length || (term.along == Along::axes && term.length->value == step) ||
                                  (term.along == Along::diagonals && term.length->value == diagonal);
        if (!is_linear(term) || term.k != scene.springs.front().k || !usual_length || !term.pairs.empty() ||
            term.between != scene.springs.front().between)
            return std::nullopt;
        axes += term.along != Along::diagonals ? 1 : 0;
        diagonals += term.along != Along::axes ? 1 : 0;
    }
    if (axes != 1 || diagonals != 1) return std::nullopt;
    return scene.springs.front().k.value;
}

std::unique_ptr<Plan> as_grid(const std::shared_ptr<const Held>& held, double mass) {
    const auto& [scene, particles] = *held;
    const auto outer = outside(scene);
    const bool plain = scene.pairs.empty() && is_open(scene) && outer && outer->drag == 0 && outer->gravity == Vec3{} &&
                       scene.particles.size() == 1 && !scene.springs.empty();
    if (!plain || scene.springs.front().between != scene.particles.front().group) return nullptr;
    const auto* grid = std::get_if<GridArrangement>(&scene.particles.front().arrangement);
    if (!grid || grid->columns < 3 || grid->rows < 3) return nullptr;
    const double step = particles[1].position.x;
    const auto k = grid_springs(scene, step);
    if (!(step >= 0) || !k || !is_on_grid(particles, *grid, step)) return nullptr;
    const GridForces forces{.rows = grid->rows, .columns = grid->columns, .mass = mass, .k = *k, .rest_length = step};
    return made(mass, 0, forces, {particles.count(), grid->columns, {step, 0, 0}, {0, 0, -step}, {}},
                start_of(held, true));
}

// One Morse potential between all particles.

bool between_all(const PairTerm& term, const SceneParticles& particles) {
    if (term.between.empty()) return true;
    for (const std::string& name : term.between) {
        if (name != "all" && particles.named(name).count != particles.count()) return false;
    }
    return true;
}

std::unique_ptr<Plan> as_pairs(const std::shared_ptr<const Held>& held, double mass) {
    const auto& [scene, particles] = *held;
    const auto outer = outside(scene);
    if (scene.pairs.size() != 1 || !scene.springs.empty() || !outer || outer->gravity != Vec3{}) return nullptr;
    const PairTerm& term = scene.pairs.front();
    if (term.potential != "morse" || !between_all(term, particles)) return nullptr;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        if (particles[i].fixed) return nullptr;
    }
    const Vec3 box = scene.box.value();
    const bool cubic = box.x == box.y && box.y == box.z;
    if (!cubic || (!term.cutoff && box.x > 0)) return nullptr;
    const PairForces pairs{particles.count(), mass, term.values.at("D").value, term.values.at("k").value,
                           term.values.at("r0").value};
    const Forces forces = term.cutoff ? Forces(NearPairForces{pairs, term.cutoff->value, box.x}) : Forces(pairs);
    return made(mass, outer->drag, forces, {particles.count(), particles.count(), {}, {}, {}}, start_of(held, false));
}

}  // namespace

Plan planned(const Scene& scene) {
    const auto held = std::make_shared<const Held>(scene);
    if (const auto mass = common_mass(held->particles)) {
        for (const auto& recognise : {as_line, as_grid, as_pairs}) {
            if (const auto plan = recognise(held, *mass)) return *plan;
        }
    }
    Composition composition = composed(held->scene, held->particles);
    SceneDamping damping = damping_of(held->scene, held->particles);
    const bool from_positions = !composition.reference.empty();
    Plan plan;
    plan.mass = composition.mass;
    plan.drag = damping.drag;
    composition.drag = std::move(damping.rates);
    plan.reference.count = plan.reference.columns = composition.count;
    plan.start = start_of(held, from_positions);
    if (from_positions) plan.reference.points = std::make_shared<const std::vector<Vec3>>(composition.reference);
    plan.masses = composition.masses;
    plan.forces = ComposedForces{composition.count, composition.mass,
                                 std::make_shared<const Composition>(std::move(composition))};
    return plan;
}

}  // namespace steplab
