#include "io/scene_reader.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/scene_appearance.hpp"
#include "io/scene_blocks.hpp"
#include "io/scene_defaults.hpp"
#include "models/scene/potential_expression.hpp"
#include "models/scene/scene_particles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;

/// Of several problems, the one that comes first in the file.
class Problems {
public:
    template <class Work>
    void attempt(const Work& work) {
        try {
            work();
        } catch (const SceneProblem& problem) {
            if (!first_ || problem.place() < first_->place()) first_ = problem;
        }
    }
    /// The same for what is wrong with the meaning of a block.
    template <class Work>
    void attempt_at(const toml::node& place, const Work& work) {
        attempt([&] {
            try {
                work();
            } catch (const UsageError& error) {
                fail_at(place, error.what());
            }
        });
    }
    void report() const {
        if (first_) throw *first_;
    }

private:
    std::optional<SceneProblem> first_;
};

/// Reads the blocks of a file, each with its place.
class Reader {
public:
    Reader(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files)
        : root_(root), numbers_(numbers), files_(files) {}

    Scene scene() {
        read_blocks();
        problems_.report();
        check_meaning();
        problems_.report();
        return std::move(scene_);
    }

private:
    void read_blocks();
    void check_meaning();
    void check_springs(const SceneParticles& particles, const SpringTerm& term) const;
    void check_pairs(const SceneParticles& particles, const PairTerm& term) const;
    static void check_field(const SceneParticles& particles, const FieldTerm& term);

    const toml::table& root_;
    SceneNumbers& numbers_;
    ParticleFiles& files_;
    Scene scene_;
    Problems problems_;
    std::vector<const toml::table*> fixes_, springs_, pairs_, fields_, blocks_;
};

void Reader::read_blocks() {
    const auto each = [this](std::string_view name, auto read, auto& blocks, auto& places) {
        problems_.attempt([&] {
            each_table(root_, name, [&](const toml::table& table) {
                problems_.attempt([&] {
                    blocks.push_back(read(table, numbers_));
                    places.push_back(&table);
                });
            });
        });
    };
    const auto particles = [this](const toml::table& table, SceneNumbers& numbers) {
        return particle_block(table, numbers, files_);
    };
    each("particles", particles, scene_.particles, blocks_);
    each("fix", fix_of, scene_.fixes, fixes_);
    each("springs", spring_term, scene_.springs, springs_);
    each("pairs", pair_term, scene_.pairs, pairs_);
    each("fields", field_term, scene_.fields, fields_);
    problems_.attempt([&] {
        if (const toml::node* const start = root_.get("start")) scene_.start = scene_start(*start, numbers_, files_);
    });
    problems_.attempt([&] {
        const toml::node* const box = root_.get("box");
        if (!box) return;
        read_keys(table_of(*box, "[box]"), "[box]",
                  {{"size",
                    [&](const toml::node& node) {
                        const auto sides = elements_of(node, "three lengths, [x, y, z]", 3, 3);
                        scene_.box = {numbers_.not_negative(*sides[0], Use::start),
                                      numbers_.not_negative(*sides[1], Use::start),
                                      numbers_.not_negative(*sides[2], Use::start)};
                    }},
                   {"corner", [&](const toml::node& node) { scene_.corner = numbers_.vector(node, Use::start); }}});
    });
}

void Reader::check_meaning() {
    if (scene_.particles.empty()) fail_at(root_, "a scene needs [[particles]]");
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        problems_.attempt([&] {
            for (std::size_t j = 0; j < i; ++j) {
                const std::string& name = scene_.particles[i].group;
                if (!name.empty() && name == scene_.particles[j].group)
                    fail_at(*blocks_[i]->get("group"), fmt::format("there is a group '{}' already", name));
            }
        });
    }
    problems_.report();
    Scene without_fixes = scene_;
    without_fixes.fixes.clear();
    const SceneParticles particles(without_fixes);
    for (std::size_t i = 0; i < fixes_.size(); ++i)
        problems_.attempt_at(*fixes_[i], [&] {
            for (const std::string& name : scene_.fixes[i].particles) particles.named(name);
        });
    problems_.attempt([&] { check_start(root_, scene_.start, particles.count()); });
    for (std::size_t i = 0; i < springs_.size(); ++i)
        problems_.attempt_at(*springs_[i], [&] { check_springs(particles, scene_.springs[i]); });
    for (std::size_t i = 0; i < pairs_.size(); ++i)
        problems_.attempt_at(*pairs_[i], [&] { check_pairs(particles, scene_.pairs[i]); });
    for (std::size_t i = 0; i < fields_.size(); ++i)
        problems_.attempt_at(*fields_[i], [&] {
            for (const std::string& name : scene_.fields[i].particles) particles.named(name);
        });
    problems_.report();
    const SceneParticles starting(scene_);
    for (std::size_t i = 0; i < fields_.size(); ++i)
        problems_.attempt_at(*fields_[i], [&] { check_field(starting, scene_.fields[i]); });
}

void Reader::check_springs(const SceneParticles& particles, const SpringTerm& term) const {
    if (!term.between.empty() && particles.group(term.between).particles.count < 2)
        throw UsageError(fmt::format("group '{}' has one particle, which has no neighbours", shown(term.between)));
    for (const auto& [one, other] : term.pairs) {
        const IndexRange first = particles.named(one), second = particles.named(other);
        if (first.count != 1 || second.count != 1)
            throw UsageError(
                fmt::format("a spring joins single particles: '{}' and '{}' name more", shown(one), shown(other)));
        if (first.first == second.first) throw UsageError(fmt::format("a spring from '{}' to itself", shown(one)));
    }
}

void Reader::check_pairs(const SceneParticles& particles, const PairTerm& term) const {
    std::vector<IndexRange> sets;
    for (const std::string& name : term.between) sets.push_back(particles.named(name));
    if (sets.empty()) sets.push_back({0, particles.count()});
    const bool within = sets.size() == 1 || sets[0] == sets[1];
    if (within && sets[0].count < 2) throw UsageError("a pair force within one particle acts on nothing");
    const Vec3 box = scene_.box.value();
    for (const double side : {box.x, box.y, box.z}) {
        if (side == 0) continue;
        if (!term.cutoff) throw UsageError("in a periodic box every pair force needs a cutoff");
        if (side < 2.3 * term.cutoff->value)
            throw UsageError(fmt::format("the box is {} long: 2.3 times the cutoff, {}, must fit into it",
                                         exact_text(side), exact_text(2.3 * term.cutoff->value)));
    }
}

void Reader::check_field(const SceneParticles& particles, const FieldTerm& term) {
    if (term.potential.empty()) return;
    std::vector<IndexRange> sets;
    for (const std::string& name : term.particles) sets.push_back(particles.named(name));
    if (sets.empty()) sets.push_back({0, particles.count()});
    const FieldPotential<double> potential(expression_of(term, 1).expression);
    for (const IndexRange set : sets) {
        for (std::size_t i = set.first; i < set.first + set.count; ++i) {
            const SceneParticle particle = particles[i];
            const Vec3 start = particle.position + particle.displacement;
            const Vector<double> at{start.x, start.y, start.z};
            const Vector<double> force = potential.force(at, particle.mass, particle.charge);
            const double energy = potential.energy(at, particle.mass, particle.charge);
            if (!std::isfinite(energy + force.x + force.y + force.z))
                throw UsageError(fmt::format("the potential is not finite where particle {} starts, at ({}, {}, {})", i,
                                             exact_text(at.x), exact_text(at.y), exact_text(at.z)));
        }
    }
}

}  // namespace

Scene read_scene(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files) {
    Scene scene = Reader(root, numbers, files).scene();
    scene.followers = numbers.followers();
    return scene;
}

SceneTexts read_texts(const toml::table& root, SceneNumbers& numbers) {
    SceneTexts texts;
    bool versioned = false;
    const auto ignore = [](const toml::node&) {};
    const auto version = [&](const toml::node& node) {
        const auto* const number = node.as_integer();
        if (!number || number->get() != 1) fail_at(node, "this program reads version 1: steplab = 1");
        versioned = true;
    };
    read_keys(root, "a scene file",
              {{"steplab", version},
               {"title", [&](const toml::node& node) { texts.title = text_of(node); }},
               {"teaches", [&](const toml::node& node) { texts.teaches = text_of(node); }},
               {"topic", [&](const toml::node& node) { texts.topic = read_topic(node); }},
               {"parameters", ignore},
               {"particles", ignore},
               {"fix", ignore},
               {"springs", ignore},
               {"pairs", ignore},
               {"fields", ignore},
               {"box", ignore},
               {"run", [&](const toml::node& node) { read_run(node, numbers, texts.defaults); }},
               {"start", ignore},
               {"view", [&](const toml::node& node) { read_view(node, texts.defaults); }}});
    if (!versioned) throw SceneProblem({1, 1}, "a scene file begins with its version: steplab = 1");
    return texts;
}

}  // namespace steplab
