#pragma once

#include "core/force_layout.hpp"
#include "io/lammps/particle_set.hpp"
#include "models/plan.hpp"
#include "models/scene/scene.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"
#include "sim/run/run_description.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace steplab {

/// What the particles of one of LAMMPS' types have in common.
struct LammpsType {
    double mass = 1;
    double charge = 0;  ///< only where the values of a table depend on it
    bool fixed = false;
    double drag = 0;                             ///< c: force -c v
    std::array<double, 3> acceleration{};        ///< from outside
    std::vector<std::array<bool, 2>> sets = {};  ///< for each pair force: whether in its first and in its second set
    std::vector<bool> fields = {};               ///< for each potential from outside: whether it acts

    auto operator<=>(const LammpsType&) const = default;  // NOLINT(modernize-use-nullptr): its comparison with 0
};

/// What springs of one of LAMMPS' bond types have in common.
struct LammpsBondType {
    double length = 0, k = 0, quadratic = 0, cubic = 0;
    const PairTerm* potential =
        nullptr;                       ///< in place of k, quadratic and cubic; the length is that of one at the start
    PairProperties<double> pair = {};  ///< what that depends on
};

/// How a pair force is written for LAMMPS.
struct LammpsPairForce {
    enum class Way {
        lennard_jones,  ///< lj/smooth/linear, without a cut-off lj/cut
        morse,          ///< morse/smooth/linear, without a cut-off morse
        charges,        ///< coul/cut: Coulomb, or gravity with masses as charges
        table,
    };
    const PairTerm* term = nullptr;
    Way way = Way::table;
    double cutoff = 0;                    ///< 0: none
    ParticleSet first = {}, second = {};  ///< equal: within one set

    double value(const char* name) const;
    /// Whether it acts between the types, the first of which is in its first set, `index` being its place in the scene.
    static bool acts(const LammpsType& one, const LammpsType& other, std::size_t index) {
        return one.sets[index][0] && other.sets[index][1];
    }
};

/// A scene in LAMMPS' terms. Nothing is stored for each particle or spring beside the scene itself.
class LammpsScene {
public:
    struct Atom {
        std::size_t type = 0;  ///< from 0
        double charge = 0;
        Vec3 position;
    };

    /// Of the run's scene and start. Throws UsageError for a term that LAMMPS has nothing for, naming it.
    explicit LammpsScene(const RunDescription& run);
    LammpsScene(const LammpsScene&) = delete;
    LammpsScene& operator=(const LammpsScene&) = delete;

    std::size_t count() const { return particles_.count(); }
    Atom atom(std::size_t i) const;
    Vec3 velocity(std::size_t i) const { return plan_.start[i].velocity; }
    const std::vector<LammpsType>& types() const { return types_; }
    const std::vector<LammpsPairForce>& pair_forces() const { return pair_forces_; }
    const std::vector<const FieldTerm*>& potentials() const { return potentials_; }
    const std::vector<LammpsBondType>& bond_types() const { return bond_types_; }
    std::uint64_t bonds() const { return bonds_; }
    /// Calls f(bond type, pair) for each spring between particles of which one at least can move.
    template <class F>
    void each_bond(F f) const;

    bool is_charged() const { return charged_; }
    /// Charges attract where their product is positive, as masses do.
    bool is_attractive() const { return attractive_; }
    bool is_nonlinear() const { return nonlinear_; }       ///< a spring is
    bool has_bond_tables() const { return bond_tables_; }  ///< a spring has a potential of its own
    bool has_fixed() const { return fixed_; }
    Vec3 box() const { return scene_.box.value(); }  ///< sides; 0: not along this axis
    Vec3 corner() const;                             ///< of the box
    Vec3 low() const { return low_; }                ///< the smallest coordinates of the start
    Vec3 high() const { return high_; }
    double longest_bond() const { return longest_bond_; }  ///< at the start or at rest; 0: none
    double nearest() const { return nearest_; }            ///< the smallest distance of two particles, of a sample
    /// Beyond every distance that the run is expected to reach.
    double reach() const;

private:
    /// Length, k, quadratic, cubic; of a term with a potential its masses and charges, and its number.
    using BondKey = std::tuple<double, double, double, double, std::size_t>;

    void add_pair_forces();
    void add_fields();
    LammpsPairForce written(const PairTerm& term);
    bool as_charges(const LammpsPairForce& force);
    void scan_particles();
    void scan_bonds();
    void find_nearest();
    LammpsType type_of(std::size_t i, const SceneParticle& particle) const;
    std::optional<BondKey> bond_key(const SpringTerm& term, const ScenePair& pair) const;
    LammpsBondType bond_type(const SpringTerm& term, const ScenePair& pair) const;
    PairProperties<double> properties(const SpringTerm& term, const ScenePair& pair) const;
    double rest_length(const SpringTerm& term, const ScenePair& pair) const;
    std::size_t number_of(const SpringTerm& term) const {
        return static_cast<std::size_t>(&term - scene_.springs.data());
    }
    Vec3 position(std::size_t i) const { return plan_.reference.at(i) + plan_.start[i].displacement; }

    struct Outside {
        const FieldTerm* term;
        ParticleSet particles;
    };

    Plan plan_;
    Scene scene_;
    SceneParticles particles_;
    std::vector<LammpsPairForce> pair_forces_;
    std::vector<Outside> outside_;
    std::vector<const FieldTerm*> potentials_;
    std::vector<LammpsType> types_;
    std::map<LammpsType, std::size_t> type_numbers_;
    std::vector<bool> of_each_pair_;  ///< of each term of springs: whether its potential takes masses or charges
    std::vector<LammpsBondType> bond_types_;
    std::map<BondKey, std::size_t> bond_numbers_;
    std::uint64_t bonds_ = 0;
    const PairTerm* charges_of_ = nullptr;  ///< the term whose strength is in the charges
    bool fixed_ = false, nonlinear_ = false, bond_tables_ = false;
    bool charged_ = false, attractive_ = false, types_by_charge_ = false;
    Vec3 low_, high_;
    double longest_bond_ = 0, nearest_ = 0;
    double rounding_ = 1;  ///< of positions: lengths that differ by less are one
};

template <class F>
void LammpsScene::each_bond(F f) const {
    for (const SpringTerm& term : scene_.springs) {
        each_spring(particles_, term, [&](const ScenePair& pair) {
            if (const auto key = bond_key(term, pair)) f(bond_numbers_.at(*key), pair);
        });
    }
}

}  // namespace steplab
