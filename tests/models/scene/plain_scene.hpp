#pragma once

#include "models/scene/scene.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::test {

using Real = long double;

struct Real3 {
    Real x = 0, y = 0, z = 0;

    friend Real3 operator+(Real3 a, Real3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Real3 operator-(Real3 a, Real3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Real3 operator*(Real s, Real3 a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline Real dot(Real3 a, Real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Real length(Real3 a) { return std::sqrt(dot(a, a)); }
inline Real3 real(Vec3 a) { return {a.x, a.y, a.z}; }

struct PlainParticle {
    Real3 reference = {}, position = {}, velocity = {};
    Real mass = 1, charge = 0;
    bool fixed = false;
};

using PlainValues = std::map<std::string, double>;

/// A pair potential as a person writes it, with its derivative by hand.
struct PairFormula {
    using Of = Real (*)(Real r, const PlainValues& values, const PlainParticle& first, const PlainParticle& second);
    std::string_view text;  ///< in a scene
    Of energy, slope;
    PlainValues values;  ///< an example
    bool sided = false;  ///< another one with the particles exchanged: it acts between two groups
    Of terms = nullptr;  ///< of terms of the slope that nearly cancel: their size; null: there are none
};
/// The built-in ones and some typed ones, of every function.
const std::vector<PairFormula>& pair_formulas();
const PairFormula& pair_formula(std::string_view text);

/// The energy of a particle in a field, with its derivatives by hand.
struct FieldFormula {
    std::string_view text;
    Real (*energy)(Real3 at, Real m, Real q);
    Real3 (*slope)(Real3 at, Real m, Real q);
};
const std::vector<FieldFormula>& field_formulas();

/// What a plain evaluation finds.
struct PlainForces {
    std::vector<Real3> forces;
    Real energy = 0;
    /// Of each particle and of the energy: the sum of the sizes of all terms, each with its change where distances
    /// change by a part of themselves. A rounding error of eps in each operation is eps times a few of these.
    std::vector<Real> sizes;
    Real energy_size = 0;
};

/// A scene evaluated from its terms in long double, pair by pair, by formulas of its own. It knows groups, "all",
/// and blocks of listed particles.
class PlainScene {
public:
    explicit PlainScene(const Scene& scene);

    std::size_t count() const { return particles_.size(); }
    const std::vector<PlainParticle>& particles() const { return particles_; }
    void place(std::size_t i, Real3 position) { particles_[i].position = position; }

    PlainForces evaluated() const;

private:
    std::vector<std::size_t> named(const std::string& name) const;
    void add_springs(const SpringTerm& term, PlainForces& sum) const;
    void add_law(const SpringTerm& term, std::size_t i, std::size_t j, PlainForces& sum) const;
    void add_pair(const PairTerm& term, std::size_t i, std::size_t j, PlainForces& sum) const;
    void add_pairs(const PairTerm& term, PlainForces& sum) const;
    void add_field(const FieldTerm& term, PlainForces& sum) const;
    Real3 nearest(Real3 d) const;

    const Scene scene_;
    std::vector<PlainParticle> particles_;
    std::map<std::string, std::vector<std::size_t>> groups_;
};

}  // namespace steplab::test
