#include "io/lammps/lammps_scene.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/scene/composer.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

/// LAMMPS keeps tables of all pairs of types; more are a scene of another kind.
constexpr std::size_t most_types = 1000;
/// Debian's LAMMPS counts particles in 32 bits.
constexpr double most_particles = 2147483647;
/// Distances of particles without a cut-off may grow to this multiple of the extent at the start.
constexpr double room = 20;

[[noreturn]] void refuse(const std::string& what) {
    throw UsageError(fmt::format("the scene cannot be expressed in LAMMPS: {}", what));
}

RunDescription checked(const RunDescription& run) {
    check(run);
    if (run.precision != Precision::double_) refuse("LAMMPS computes in double, not in float");
    if (run.dt < 0) refuse("LAMMPS has no negative time step");
    const double count = model_of(run).particles(run.scene);
    if (count > most_particles) refuse(fmt::format("it counts particles in 32 bits, and there are {:.0f}", count));
    return as_held(run);
}

ParticleSet set_of(const SceneParticles& particles, const std::vector<std::string>& names) {
    std::vector<IndexRange> ranges;
    ranges.reserve(names.size());
    for (const std::string& name : names) ranges.push_back(particles.named(name));
    if (names.empty()) ranges.push_back({0, particles.count()});
    return ParticleSet(std::move(ranges));
}

Vec3 lower(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 upper(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// The way to the nearest image.
Vec3 nearest_image(Vec3 way, Vec3 box) {
    Shape space;
    space.box = box;
    return space.nearest(way);
}

}  // namespace

double LammpsPairForce::value(const char* name) const {
    const auto given = term->values.find(name);
    return given == term->values.end() ? 0 : given->second.value;
}

LammpsScene::LammpsScene(const RunDescription& run)
    : plan_(plan_of(checked(run))), scene_(model_of(run).scene(as_held(run).scene)), particles_(scene_) {
    add_pair_forces();
    add_fields();
    scan_particles();
    scan_bonds();
    find_nearest();
}

void LammpsScene::add_pair_forces() {
    for (const PairTerm& term : scene_.pairs) {
        pair_forces_.push_back(written(term));
        const bool within = pair_forces_.back().first == pair_forces_.back().second;
        if (!within && pair_forces_.back().first.overlaps(pair_forces_.back().second))
            refuse("a pair force between two groups that have particles in common");
    }
    const bool any_table = std::any_of(pair_forces_.begin(), pair_forces_.end(),
                                       [](const auto& force) { return force.way == LammpsPairForce::Way::table; });
    types_by_charge_ = any_table;
    charged_ = charges_of_ != nullptr;
}

LammpsPairForce LammpsScene::written(const PairTerm& term) {
    using Way = LammpsPairForce::Way;
    const auto& between = term.between;
    LammpsPairForce force{.term = &term, .cutoff = term.cutoff ? term.cutoff->value : 0};
    force.first = set_of(particles_, between.empty() ? between : std::vector{between.front()});
    force.second = between.size() < 2 ? force.first : set_of(particles_, {between[1]});
    if (term.potential == "lennard-jones") force.way = Way::lennard_jones;
    if (term.potential == "morse") force.way = Way::morse;
    if (as_charges(force)) force.way = Way::charges;
    return force;
}

/// The strength of Coulomb's law or of gravity is taken into the charges, for one strength.
bool LammpsScene::as_charges(const LammpsPairForce& force) {
    const bool masses = force.term->potential == "gravity", charges = force.term->potential == "coulomb";
    if (!(masses || charges) || force.cutoff > 0 || force.value("softening") != 0) return false;
    const char* const name = masses ? "G" : "K";
    if (charges_of_ &&
        (charges_of_->potential != force.term->potential || charges_of_->values.at(name).value != force.value(name)))
        return false;
    charges_of_ = force.term;
    attractive_ = masses == (force.value(name) > 0);
    return true;
}

void LammpsScene::add_fields() {
    for (const FieldTerm& term : scene_.fields) {
        outside_.push_back({&term, set_of(particles_, term.particles)});
        if (!term.potential.empty()) potentials_.push_back(&term);
    }
    for (const SpringTerm& term : scene_.springs) {
        if (term.damping.value != 0) refuse("a spring with damping (a dashpot)");
        of_each_pair_.push_back(term.potential && takes_properties(pair_force_of(*term.potential, 1)));
    }
}

LammpsType LammpsScene::type_of(std::size_t i, const SceneParticle& particle) const {
    LammpsType type{.mass = particle.mass, .fixed = particle.fixed};
    if (types_by_charge_) type.charge = particle.charge;
    for (const LammpsPairForce& force : pair_forces_)
        type.sets.push_back({force.first.contains(i), force.second.contains(i)});
    for (const Outside& outside : outside_) {
        const bool acts = !particle.fixed && outside.particles.contains(i);
        const Vec3 gravity = acts && outside.term->gravity ? outside.term->gravity->value() : Vec3{};
        type.acceleration[0] += gravity.x, type.acceleration[1] += gravity.y, type.acceleration[2] += gravity.z;
        if (acts && outside.term->drag) type.drag += outside.term->drag->value;
        if (!outside.term->potential.empty()) type.fields.push_back(acts);
    }
    return type;
}

void LammpsScene::scan_particles() {
    low_ = high_ = position(0);
    for (std::size_t i = 0; i < count(); ++i) {
        if (i % 4096 == 0) check_interruption();
        const Vec3 at = position(i);
        low_ = lower(low_, at), high_ = upper(high_, at);
        const auto [place, added] = type_numbers_.try_emplace(type_of(i, particles_[i]), types_.size());
        if (added) types_.push_back(place->first);
        fixed_ = fixed_ || place->first.fixed;
        if (types_.size() > most_types)
            refuse(fmt::format("more than {} kinds of particles, by mass, charge and what acts on them", most_types));
    }
}

double LammpsScene::rest_length(const SpringTerm& term, const ScenePair& pair) const {
    if (term.length) return term.length->value;
    return length(nearest_image(particles_[pair.second].position - particles_[pair.first].position, box()));
}

/// Lengths that differ by no more than the rounding of positions are one.
std::optional<LammpsScene::BondKey> LammpsScene::bond_key(const SpringTerm& term, const ScenePair& pair) const {
    if (has_fixed() && particles_[pair.first].fixed && particles_[pair.second].fixed) return std::nullopt;
    if (term.potential) {
        const auto [first_mass, second_mass, first_charge, second_charge] = properties(term, pair);
        return BondKey{first_mass, second_mass, first_charge, second_charge, number_of(term) + 1};
    }
    const double length = rest_length(term, pair);
    return BondKey{std::round(length / rounding_) * rounding_, term.k.value, term.quadratic.value, term.cubic.value, 0};
}

/// Those of the pair, the lower number first, if the potential of the term depends on them.
PairProperties<double> LammpsScene::properties(const SpringTerm& term, const ScenePair& pair) const {
    if (!of_each_pair_[number_of(term)]) return {};
    const auto [lower, upper] = std::minmax(pair.first, pair.second);
    const SceneParticle one = particles_[lower], other = particles_[upper];
    return {one.mass, other.mass, one.charge, other.charge};
}

LammpsBondType LammpsScene::bond_type(const SpringTerm& term, const ScenePair& pair) const {
    if (!term.potential) return {rest_length(term, pair), term.k.value, term.quadratic.value, term.cubic.value};
    const double now = length(nearest_image(position(pair.second) - position(pair.first), box()));
    return {.length = now, .potential = &*term.potential, .pair = properties(term, pair)};
}

void LammpsScene::scan_bonds() {
    const double extent = std::max({length(low_), length(high_), std::numeric_limits<double>::min()});
    rounding_ = std::ldexp(1.0, std::ilogb(extent) - 51);
    for (const SpringTerm& term : scene_.springs) {
        each_spring(particles_, term, [&](const ScenePair& pair) {
            const auto key = bond_key(term, pair);
            if (!key) return;
            if (bonds_++ % 4096 == 0) check_interruption();
            if (bond_numbers_.try_emplace(*key, bond_types_.size()).second)
                bond_types_.push_back(bond_type(term, pair));
            nonlinear_ = nonlinear_ || term.quadratic.value != 0 || term.cubic.value != 0;
            bond_tables_ = bond_tables_ || term.potential;
            const double now = length(nearest_image(position(pair.second) - position(pair.first), box()));
            longest_bond_ = std::max({longest_bond_, now, rest_length(term, pair)});
        });
    }
}

/// Tables begin well below it.
void LammpsScene::find_nearest() {
    if (!types_by_charge_ || count() < 2) return;
    const std::size_t sample = std::clamp<std::size_t>(100'000'000 / count(), 10, std::min<std::size_t>(1000, count()));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count(); ++i) {
        if (i % 64 == 0) check_interruption();
        const Vec3 at = position(i);
        for (std::size_t k = 0; k < sample; ++k) {
            const std::size_t other = k * count() / sample;
            const double distance = length(nearest_image(position(other) - at, box()));
            if (distance > 0) least = std::min(least, distance);
        }
    }
    nearest_ = std::isfinite(least) ? least : 1;
}

LammpsScene::Atom LammpsScene::atom(std::size_t i) const {
    const SceneParticle particle = particles_[i];
    Atom atom{.type = type_numbers_.at(type_of(i, particle)), .position = position(i)};
    if (charges_of_) {
        const bool masses = charges_of_->potential == "gravity";
        const double strength = charges_of_->values.at(masses ? "G" : "K").value;
        atom.charge = std::sqrt(std::abs(strength)) * (masses ? particle.mass : particle.charge);
    }
    return atom;
}

Vec3 LammpsScene::corner() const {
    return scene_.corner ? scene_.corner->value() : low_ - 0.5 * (box() - (high_ - low_));
}

double LammpsScene::reach() const {
    const double extent = length(high_ - low_);
    return room * (extent > 0 ? extent : std::max(longest_bond_, 1.0));
}

}  // namespace steplab
