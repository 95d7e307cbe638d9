#include "io/scene_reader.hpp"

#include "core/error.hpp"
#include "core/precision.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "models/scene/composer.hpp"
#include "models/scene/scene_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

std::vector<std::string> texts_of(const toml::node& node) {
    std::vector<std::string> texts;
    const auto add = [&](const toml::node& element) {
        if (const auto* const number = element.as_integer()) return texts.push_back(std::to_string(number->get()));
        texts.push_back(text_of(element));
    };
    if (const toml::array* const array = node.as_array()) {
        for (const toml::node& element : *array) add(element);
    } else {
        add(node);
    }
    if (texts.empty()) fail_at(node, "must name at least one particle");
    return texts;
}

std::string group_name(const toml::node& node) {
    std::string name = text_of(node);
    const auto is_part = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    const bool begins = !name.empty() && is_part(name[0]) && name[0] != '-' && !(name[0] >= '0' && name[0] <= '9');
    if (!begins || !std::all_of(name.begin(), name.end(), is_part) || name == "all")
        fail_at(node, "the name of a group begins with a letter, then letters, digits, _ and - (not \"all\")");
    return name;
}

Role role_of(const toml::node& node) {
    const std::string word = word_of(node, "role", {"moving", "fixed", "kicked", "bullet"});
    return word == "kicked"   ? Role::kicked
           : word == "bullet" ? Role::bullet
           : word == "fixed"  ? Role::fixed
                              : Role::moving;
}

/// Reads the blocks of a file, each with its place.
class Reader {
public:
    Reader(const toml::table& root, SceneNumbers& numbers) : root_(root), numbers_(numbers) {}

    Scene scene() {
        read_blocks();
        problems_.report();
        check_meaning();
        problems_.report();
        return std::move(scene_);
    }

private:
    void read_blocks();
    void read_particles(const toml::table& table);
    void read_arrangement(const toml::table& table, ParticleBlock& block, const toml::node& node);
    LineArrangement line(const toml::node& node);
    GridArrangement grid(const toml::node& node);
    CrystalArrangement crystal(const toml::node& node);
    void read_displacement(ParticleBlock& block, const toml::node& node);
    Temperature temperature(const toml::node& node);
    void read_fix(const toml::table& table);
    void read_springs(const toml::table& table);
    void read_pairs(const toml::table& table);
    void check_values_of(const PairTerm& term, const toml::table& table, const toml::node& potential);
    void read_field(const toml::table& table);

    void check_meaning();
    void check_springs(const SceneParticles& particles, const SpringTerm& term) const;
    void check_pairs(const SceneParticles& particles, const PairTerm& term) const;

    WrittenNumber force(const toml::node& node) { return numbers_.quantity(node, Use::force); }

    const toml::table& root_;
    SceneNumbers& numbers_;
    Scene scene_;
    Problems problems_;
    std::vector<const toml::table*> fixes_, springs_, pairs_, fields_, blocks_;
};

void Reader::read_blocks() {
    const auto each = [this](std::string_view name, void (Reader::*read)(const toml::table&)) {
        problems_.attempt([&] {
            each_table(root_, name,
                       [&](const toml::table& table) { problems_.attempt([&] { (this->*read)(table); }); });
        });
    };
    each("particles", &Reader::read_particles);
    each("fix", &Reader::read_fix);
    each("springs", &Reader::read_springs);
    each("pairs", &Reader::read_pairs);
    each("fields", &Reader::read_field);
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

void Reader::read_particles(const toml::table& table) {
    ParticleBlock& block = scene_.particles.emplace_back();
    blocks_.push_back(&table);
    const auto arrangement = [&](const toml::node& node) { read_arrangement(table, block, node); };
    read_keys(table, "[[particles]]",
              {{"group", [&](const toml::node& node) { block.group = group_name(node); }},
               {"position", [&](const toml::node& node) { block.position = numbers_.vector(node, Use::start); }},
               {"velocity", [&](const toml::node& node) { block.velocity = numbers_.vector(node, Use::start); }},
               {"mass", [&](const toml::node& node) { block.mass = numbers_.positive(node, Use::force); }},
               {"charge", [&](const toml::node& node) { block.charge = force(node); }},
               {"fixed", [&](const toml::node& node) { block.fixed = flag_of(node); }},
               {"role", [&](const toml::node& node) { block.role = role_of(node); }},
               {"line", arrangement},
               {"grid", arrangement},
               {"lattice", arrangement},
               {"file", [](const toml::node& node) { fail_at(node, "particles cannot be read from a file so far"); }},
               {"displacement", [&](const toml::node& node) { read_displacement(block, node); }},
               {"temperature", [&](const toml::node& node) { block.temperature = temperature(node); }}});
}

void Reader::read_arrangement(const toml::table& table, ParticleBlock& block, const toml::node& node) {
    if (block.arrangement.index() != 0) fail_at(node, "a block has at most one of line, grid, lattice and file");
    if (table.get("line") == &node) block.arrangement = line(node);
    if (table.get("grid") == &node) block.arrangement = grid(node);
    if (table.get("lattice") == &node) block.arrangement = crystal(node);
}

LineArrangement Reader::line(const toml::node& node) {
    LineArrangement line{.count = 0, .step = {}};
    read_keys(table_of(node, "line"), "line",
              {{"count", [&](const toml::node& given) { line.count = numbers_.count(given, 1); }},
               {"step", [&](const toml::node& given) { line.step = numbers_.vector(given, Use::start); }}});
    if (line.count == 0) fail_at(node, "a line needs a count");
    return line;
}

GridArrangement Reader::grid(const toml::node& node) {
    GridArrangement grid{.columns = 0, .rows = 0, .steps = {}};
    const auto count = [&](const toml::node& given) {
        const auto both = elements_of(given, "two numbers, [columns, rows]", 2, 2);
        grid.columns = numbers_.count(*both[0], 1);
        grid.rows = numbers_.count(*both[1], 1);
        if (static_cast<double>(grid.columns) * static_cast<double>(grid.rows) > 4294967295.0)
            fail_at(given, "there may be at most 4294967295 particles");
    };
    const auto steps = [&](const toml::node& given) {
        const auto both = elements_of(given, "two vectors, [[x, y, z], [x, y, z]]", 2, 2);
        grid.steps = {numbers_.vector(*both[0], Use::start), numbers_.vector(*both[1], Use::start)};
    };
    read_keys(table_of(node, "grid"), "grid", {{"count", count}, {"steps", steps}});
    if (grid.rows == 0) fail_at(node, "a grid needs a count");
    return grid;
}

CrystalArrangement Reader::crystal(const toml::node& node) {
    CrystalArrangement crystal{.kind = CrystalArrangement::Kind::cubic, .cells = {0, 0, 0}, .constant = 1};
    const auto kind = [&](const toml::node& given) {
        const std::string word = word_of(given, "lattice", {"cubic", "bcc", "fcc"});
        using Kind = CrystalArrangement::Kind;
        crystal.kind = word == "bcc" ? Kind::bcc : word == "fcc" ? Kind::fcc : Kind::cubic;
    };
    const auto cells = [&](const toml::node& given) {
        const auto all = elements_of(given, "three numbers of cells, [x, y, z]", 3, 3);
        double product = 4;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            crystal.cells[axis] = numbers_.count(*all[axis], 1);
            product *= static_cast<double>(crystal.cells[axis]);
        }
        if (product > 4294967295.0) fail_at(given, "there may be at most 4294967295 particles");
    };
    read_keys(table_of(node, "lattice"), "lattice",
              {{"kind", kind}, {"cells", cells}, {"constant", [&](const toml::node& given) {
                                                      crystal.constant = numbers_.quantity(given, Use::start);
                                                  }}});
    if (crystal.cells[0] == 0) fail_at(node, "a lattice needs cells");
    return crystal;
}

void Reader::read_displacement(ParticleBlock& block, const toml::node& node) {
    if (!node.is_table()) {
        block.displacement = numbers_.vector(node, Use::start);
        return;
    }
    RandomDisplacement random;
    read_keys(table_of(node, "displacement"), "displacement",
              {{"random", [&](const toml::node& given) { random.width = numbers_.not_negative(given, Use::start); }},
               {"seed", [&](const toml::node& given) { random.seed = numbers_.seed(given); }}});
    block.displacement = random;
}

Temperature Reader::temperature(const toml::node& node) {
    Temperature temperature;
    read_keys(table_of(node, "temperature"), "temperature",
              {{"kT", [&](const toml::node& given) { temperature.kT = numbers_.not_negative(given, Use::start); }},
               {"seed", [&](const toml::node& given) { temperature.seed = numbers_.seed(given); }},
               {"exact", [&](const toml::node& given) { temperature.exact = flag_of(given); }}});
    return temperature;
}

void Reader::read_fix(const toml::table& table) {
    Fix& fix = scene_.fixes.emplace_back();
    fixes_.push_back(&table);
    read_keys(table, "[[fix]]",
              {{"particles", [&](const toml::node& node) { fix.particles = texts_of(node); }},
               {"fixed", [&](const toml::node& node) { fix.fixed = flag_of(node); }},
               {"velocity", [&](const toml::node& node) { fix.velocity = numbers_.vector(node, Use::start); }},
               {"displacement", [&](const toml::node& node) { fix.displacement = numbers_.vector(node, Use::start); }},
               {"mass", [&](const toml::node& node) { fix.mass = numbers_.positive(node, Use::force); }},
               {"charge", [&](const toml::node& node) { fix.charge = force(node); }},
               {"role", [&](const toml::node& node) { fix.role = role_of(node); }}});
    if (fix.particles.empty()) fail_at(table, "[[fix]] needs particles");
}

void Reader::read_springs(const toml::table& table) {
    SpringTerm& term = scene_.springs.emplace_back();
    springs_.push_back(&table);
    const auto along = [&](const toml::node& node) {
        using Along = SpringTerm::Along;
        const std::string word = word_of(node, "direction", {"axes", "diagonals", "both"});
        term.along = word == "axes" ? Along::axes : word == "both" ? Along::both : Along::diagonals;
    };
    const auto pairs = [&](const toml::node& node) {
        for (const toml::node* const pair : elements_of(node, "a list of pairs of particles", 0, 1u << 24)) {
            const auto both = texts_of(*pair);
            if (both.size() != 2) fail_at(*pair, "a spring joins two particles");
            term.pairs.emplace_back(both[0], both[1]);
        }
    };
    bool has_k = false;
    read_keys(table, "[[springs]]",
              {{"between", [&](const toml::node& node) { term.between = text_of(node); }},
               {"along", along},
               {"pairs", pairs},
               {"k", [&](const toml::node& node) { term.k = numbers_.not_negative(node, Use::force), has_k = true; }},
               {"length", [&](const toml::node& node) { term.length = numbers_.not_negative(node, Use::force); }},
               {"damping", [&](const toml::node& node) { term.damping = numbers_.not_negative(node, Use::force); }},
               {"quadratic", [&](const toml::node& node) { term.quadratic = force(node); }},
               {"cubic", [&](const toml::node& node) { term.cubic = force(node); }}});
    if (!has_k) fail_at(table, "[[springs]] needs k, the force constant");
    if (term.between.empty() && term.pairs.empty()) fail_at(table, "[[springs]] needs between or pairs");
}

void Reader::read_pairs(const toml::table& table) {
    PairTerm& term = scene_.pairs.emplace_back();
    pairs_.push_back(&table);
    const toml::node* potential = nullptr;
    read_keys(table, "[[pairs]]",
              {{"between",
                [&](const toml::node& node) {
                    term.between = texts_of(node);
                    if (term.between.size() > 2) fail_at(node, "between takes one group or two");
                }},
               {"potential", [&](const toml::node& node) { term.potential = text_of(node), potential = &node; }},
               {"cutoff", [&](const toml::node& node) { term.cutoff = numbers_.positive(node, Use::force); }}},
              [&](const std::string& name, const toml::node& node) { term.values[name] = force(node); });
    if (!potential) fail_at(table, "[[pairs]] needs a potential");
    check_values_of(term, table, *potential);
}

/// The values must be those of the potential.
void Reader::check_values_of(const PairTerm& term, const toml::table& table, const toml::node& potential) {
    const BuiltInPotential* const built_in = built_in_potential(term.potential);
    if (!built_in) {
        const bool word = std::all_of(term.potential.begin(), term.potential.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
        });
        const std::vector<std::string_view> known{"morse", "lennard-jones", "gravity", "coulomb"};
        if (word) fail_at(potential, unknown_word("potential", term.potential, known));
        fail_at(potential,
                "an expression as a potential cannot be stepped so far; built-in ones are morse, "
                "lennard-jones, gravity and coulomb");
    }
    std::vector<std::string_view> known;
    for (const BuiltInPotential::Value& value : built_in->values) known.push_back(value.name);
    for (const auto& [name, quantity] : term.values) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            fail_at(*table.get(name), unknown_word("value", name, known, term.potential));
    }
    for (const BuiltInPotential::Value& value : built_in->values) {
        if (value.required && !term.values.contains(std::string(value.name)))
            fail_at(table, fmt::format("the potential {} needs a value of {}", term.potential, value.name));
    }
    for (const char* const name : {"D", "k", "sigma"}) {
        const auto given = term.values.find(name);
        if (given != term.values.end() && !(given->second.value > 0))
            fail_at(*table.get(name), fmt::format("{} must be > 0", name));
    }
}

void Reader::read_field(const toml::table& table) {
    FieldTerm& field = scene_.fields.emplace_back();
    fields_.push_back(&table);
    read_keys(table, "[[fields]]",
              {{"particles", [&](const toml::node& node) { field.particles = texts_of(node); }},
               {"gravity", [&](const toml::node& node) { field.gravity = numbers_.vector(node, Use::force); }},
               {"drag", [&](const toml::node& node) { field.drag = numbers_.not_negative(node, Use::force); }},
               {"potential",
                [](const toml::node& node) { fail_at(node, "the potential of a field cannot be stepped so far"); }}});
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
    for (std::size_t i = 0; i < springs_.size(); ++i)
        problems_.attempt_at(*springs_[i], [&] { check_springs(particles, scene_.springs[i]); });
    for (std::size_t i = 0; i < pairs_.size(); ++i)
        problems_.attempt_at(*pairs_[i], [&] { check_pairs(particles, scene_.pairs[i]); });
    for (std::size_t i = 0; i < fields_.size(); ++i)
        problems_.attempt_at(*fields_[i], [&] {
            for (const std::string& name : scene_.fields[i].particles) particles.named(name);
        });
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

void read_defaults(const toml::node& node, SceneNumbers& numbers, SceneDefaults& defaults) {
    read_keys(table_of(node, "[run]"), "[run]",
              {{"method", [&](const toml::node& given) { defaults.method = text_of(given); }},
               {"dt", [&](const toml::node& given) { defaults.dt = numbers.positive(given, Use::start).value; }},
               {"precision",
                [&](const toml::node& given) {
                    defaults.precision = word_of(given, "precision", {"float", "double"});
                }},
               {"until", [&](const toml::node& given) { defaults.until = numbers.positive(given, Use::start).value; }},
               {"compare", [&](const toml::node& given) { defaults.compare = texts_of(given); }}});
}

}  // namespace

Scene read_scene(const toml::table& root, SceneNumbers& numbers) {
    Scene scene = Reader(root, numbers).scene();
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
    const auto view = [&](const toml::node& node) {
        read_keys(table_of(node, "[view]"), "[view]",
                  {{"camera", [&](const toml::node& given) { texts.defaults.camera = text_of(given); }},
                   {"colour", [&](const toml::node& given) { texts.defaults.colour = text_of(given); }},
                   {"background", [&](const toml::node& given) { texts.defaults.background = text_of(given); }}});
    };
    read_keys(root, "a scene file",
              {{"steplab", version},
               {"title", [&](const toml::node& node) { texts.title = text_of(node); }},
               {"teaches", [&](const toml::node& node) { texts.teaches = text_of(node); }},
               {"parameters", ignore},
               {"particles", ignore},
               {"fix", ignore},
               {"springs", ignore},
               {"pairs", ignore},
               {"fields", ignore},
               {"box", ignore},
               {"run", [&](const toml::node& node) { read_defaults(node, numbers, texts.defaults); }},
               {"start", [](const toml::node& node) { fail_at(node, "[start] cannot be used so far"); }},
               {"view", view}});
    if (!versioned) throw SceneProblem({1, 1}, "a scene file begins with its version: steplab = 1");
    return texts;
}

}  // namespace steplab
