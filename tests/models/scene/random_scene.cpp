#include "models/scene/random_scene.hpp"

#include "models/scene/plain_scene.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {

namespace {

constexpr double step = 15.0 / 1024;
constexpr int apart = 60, jitter = 19;  // steps between neighbours of a lattice, and how far they may leave it

class SceneMaker {
public:
    SceneMaker(const RandomScene& wanted, unsigned seed) : wanted_(wanted), random_(seed) {}

    Scene made() {
        add_particles();
        if (!wanted_.pairs || wanted_.network || chance(0.5)) add_springs();
        if (wanted_.pairs) add_pairs();
        if (wanted_.fields) add_fields();
        return std::move(scene_);
    }

private:
    int whole(int from, int to) { return std::uniform_int_distribution(from, to)(random_); }
    double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(random_); }
    bool chance(double of) { return uniform(0, 1) < of; }
    Vec3 steps(int most) { return {step * whole(-most, most), step * whole(-most, most), step * whole(-most, most)}; }
    static WrittenVector written(Vec3 v) { return {v.x, v.y, v.z}; }
    std::string any_particle() { return std::to_string(whole(0, static_cast<int>(count_) - 1)); }
    std::string any_group() { return chance(0.5) ? "g0" : "g1"; }

    void add_particles() {
        const int least = static_cast<int>(wanted_.least), most = static_cast<int>(wanted_.most);
        const std::array sizes{whole(least, most), whole(least, most)};
        count_ = static_cast<std::size_t>(sizes[0] + sizes[1]);
        int side = 4;
        while (static_cast<std::size_t>(side * side * side) < count_) ++side;
        std::vector<int> cells(static_cast<std::size_t>(side * side * side));
        std::iota(cells.begin(), cells.end(), 0);
        std::shuffle(cells.begin(), cells.end(), random_);
        const double period = step * apart * side + 1.0 / 2048;  // no difference is exactly half of it
        scene_.box = {wanted_.periodic > 0 ? period : 0, wanted_.periodic > 2 ? period : 0,
                      wanted_.periodic > 1 ? period : 0};
        std::size_t next = 0;
        for (const int size : sizes) {
            auto listed = std::make_shared<std::vector<ListedParticles::Particle>>();
            for (int i = 0; i < size; ++i, ++next) {
                const int cell = cells[next];
                const Vec3 corner{step * apart * (cell % side), step * apart * (cell / side % side),
                                  step * apart * (cell / side / side)};
                const Vec3 off = wanted_.rounded ? Vec3{} : Vec3{uniform(0, step), uniform(0, step), uniform(0, step)};
                listed->push_back({.position = corner + steps(jitter) + off,
                                   .velocity = steps(60),
                                   .mass = wanted_.spread ? uniform(0.5, 3) : 1.7});
            }
            ListedParticles block{.file = "made", .masses = true};
            block.particles = std::move(listed);
            scene_.particles.push_back(
                {.group = next == static_cast<std::size_t>(sizes[0]) ? "g0" : "g1", .arrangement = std::move(block)});
        }
        for (std::size_t i = 0; i < count_; ++i) {
            Fix fix{.particles = {std::to_string(i)}};
            fix.charge = uniform(-1, 1);
            if (chance(0.3)) fix.displacement = written(steps(4));
            if (wanted_.fixed && (i == 1 || chance(0.1))) fix.fixed = true;
            scene_.fixes.push_back(std::move(fix));
        }
    }

    void add_springs() {
        const auto spring = [&](const std::string& first, const std::string& second) {
            SpringTerm term;
            term.pairs = {{first, second}};
            term.k = uniform(0.5, 5);
            if (chance(0.5)) term.length = chance(0.2) ? 0 : uniform(0.3, 2);
            if (chance(0.3)) term.quadratic = uniform(-1, 1);
            if (chance(0.3)) term.cubic = uniform(0, 2);
            if (wanted_.damped && chance(0.5)) term.damping = uniform(0.1, 2);
            if (wanted_.laws && chance(0.7)) term.potential = written(any_formula());
            if (first != second) scene_.springs.push_back(std::move(term));
        };
        const int count = static_cast<int>(count_);
        for (int i = 0; wanted_.network && i + 3 < count; ++i) {
            spring(std::to_string(i), std::to_string(i + 1));
            spring(std::to_string(i), std::to_string(i + 3));
        }
        for (int i = 0; i < (wanted_.network ? 3 : 6); ++i) spring(any_particle(), any_particle());
    }

    const PairFormula& any_formula() {
        const auto& formulas = pair_formulas();
        return formulas[static_cast<std::size_t>(whole(0, static_cast<int>(formulas.size()) - 1))];
    }
    static PairTerm written(const PairFormula& formula) {
        PairTerm term;
        term.potential = std::string(formula.text);
        for (const auto& [name, value] : formula.values) term.values[name] = value;
        return term;
    }

    void add_pairs() {
        const int terms = wanted_.plain ? 1 : whole(2, 4);
        for (int t = 0; t < terms; ++t) {
            const PairFormula* formula = nullptr;
            const auto suits = [&] {
                const bool weighted = formula->text.find_first_of("mq") != std::string_view::npos ||
                                      formula->text == "gravity" || formula->text == "coulomb";
                return !wanted_.plain || formula->text == "morse" || !weighted;
            };
            do formula = &any_formula();
            while (!suits());
            PairTerm term = written(*formula);
            if (formula->sided) {
                term.between =
                    chance(0.5) ? std::vector<std::string>{"g0", "g1"} : std::vector<std::string>{"g1", "g0"};
            } else if (!wanted_.plain && chance(0.6)) {
                term.between = {any_group(), any_group()};
            }
            if (wanted_.cutoff > 0 && !(wanted_.some_open && chance(0.5))) term.cutoff = wanted_.cutoff;
            scene_.pairs.push_back(std::move(term));
        }
    }

    void add_fields() {
        const auto of = [&](double all) {
            if (chance(all)) return std::vector<std::string>{};
            return std::vector<std::string>{any_group()};
        };
        if (chance(0.5)) scene_.fields.push_back({.particles = of(0.5), .gravity = written(steps(200))});
        if (wanted_.damped || chance(0.5)) scene_.fields.push_back({.particles = of(0.5), .drag = uniform(0.1, 1)});
        const auto& formulas = field_formulas();
        if (wanted_.periodic > 0 || chance(0.4)) return;
        scene_.fields.push_back(
            {.particles = of(0.5),
             .potential = std::string(
                 formulas[static_cast<std::size_t>(whole(0, static_cast<int>(formulas.size()) - 1))].text)});
    }

    RandomScene wanted_;
    std::mt19937 random_;
    Scene scene_;
    std::size_t count_ = 0;
};

}  // namespace

Scene random_scene(const RandomScene& wanted, unsigned seed) { return SceneMaker(wanted, seed).made(); }

// The quaternion 1 + i + 2 j + 3 k of norm 15: the matrix is one of whole numbers divided by 15.
Vec3 turned(Vec3 v) {
    return {(-11 * v.x - 2 * v.y + 10 * v.z) / 15, (10 * v.x - 5 * v.y + 10 * v.z) / 15,
            (2 * v.x + 14 * v.y + 5 * v.z) / 15};
}

Scene turned_scene(const Scene& scene, Vec3 shift) {
    Scene other = scene;
    for (ParticleBlock& block : other.particles) {
        auto& listed = std::get<ListedParticles>(block.arrangement);
        auto particles = std::make_shared<std::vector<ListedParticles::Particle>>(*listed.particles);
        for (ListedParticles::Particle& one : *particles) {
            one.position = turned(one.position) + shift;
            one.velocity = turned(one.velocity);
        }
        listed.particles = std::move(particles);
    }
    const auto turn = [](WrittenVector& v) {
        const Vec3 to = turned(v.value());
        v = {to.x, to.y, to.z};
    };
    for (Fix& fix : other.fixes) {
        if (fix.displacement) turn(*fix.displacement);
    }
    for (FieldTerm& field : other.fields) {
        if (field.gravity) turn(*field.gravity);
    }
    return other;
}

}  // namespace steplab::test
