#include "io/scene_blocks.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "models/potentials/list.hpp"
#include "models/scene/potential_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;

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

/// Who has the role of a fixed particle is one.
bool fixed_by_role(const toml::table& table) {
    const toml::node* const fixed = table.get("fixed");
    if (fixed && !flag_of(*fixed))
        fail_at(*table.get("role"), "a particle of the role \"fixed\" is fixed: leave the role out, or fixed = false");
    return true;
}

LineArrangement line(const toml::node& node, SceneNumbers& numbers) {
    LineArrangement line{.count = 0, .step = {}};
    read_keys(table_of(node, "line"), "line",
              {{"count", [&](const toml::node& given) { line.count = numbers.count(given, 1); }},
               {"step", [&](const toml::node& given) { line.step = numbers.vector(given, Use::start); }}});
    if (line.count == 0) fail_at(node, "a line needs a count");
    return line;
}

GridArrangement grid(const toml::node& node, SceneNumbers& numbers) {
    GridArrangement grid{.columns = 0, .rows = 0, .steps = {}};
    const auto count = [&](const toml::node& given) {
        const auto both = elements_of(given, "two numbers, [columns, rows]", 2, 2);
        grid.columns = numbers.count(*both[0], 1);
        grid.rows = numbers.count(*both[1], 1);
        if (static_cast<double>(grid.columns) * static_cast<double>(grid.rows) > 4294967295.0)
            fail_at(given, "there may be at most 4294967295 particles");
    };
    const auto steps = [&](const toml::node& given) {
        const auto both = elements_of(given, "two vectors, [[x, y, z], [x, y, z]]", 2, 2);
        grid.steps = {numbers.vector(*both[0], Use::start), numbers.vector(*both[1], Use::start)};
    };
    read_keys(table_of(node, "grid"), "grid", {{"count", count}, {"steps", steps}});
    if (grid.rows == 0) fail_at(node, "a grid needs a count");
    return grid;
}

CrystalArrangement crystal(const toml::node& node, SceneNumbers& numbers) {
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
            crystal.cells[axis] = numbers.count(*all[axis], 1);
            product *= static_cast<double>(crystal.cells[axis]);
        }
        if (product > 4294967295.0) fail_at(given, "there may be at most 4294967295 particles");
    };
    read_keys(table_of(node, "lattice"), "lattice",
              {{"kind", kind}, {"cells", cells}, {"constant", [&](const toml::node& given) {
                                                      crystal.constant = numbers.quantity(given, Use::start);
                                                  }}});
    if (crystal.cells[0] == 0) fail_at(node, "a lattice needs cells");
    return crystal;
}

ListedParticles listed(const toml::node& node, ParticleFiles& files) {
    try {
        return files.particles(text_of(node));
    } catch (const FileError& error) {
        fail_at(node, error.what());
    }
}

/// What the block says goes before what the file says; one mass of all is the block's.
void settle_listed(const toml::table& table, ParticleBlock& block) {
    auto* const list = std::get_if<ListedParticles>(&block.arrangement);
    if (!list) return;
    list->roles = list->roles && !table.contains("role") && !table.contains("fixed");
    list->masses = list->masses && !table.contains("mass");
    const double first = list->particles->front().mass;
    const bool equal = std::all_of(list->particles->begin(), list->particles->end(),
                                   [first](const auto& particle) { return particle.mass == first; });
    if (list->masses && equal) block.mass = first, list->masses = false;
    if (list->masses && block.temperature)
        fail_at(*table.get("temperature"), "the masses in the file differ: a temperature needs one mass of the block");
}

void read_arrangement(const toml::table& table, ParticleBlock& block, const toml::node& node, SceneNumbers& numbers,
                      ParticleFiles& files) {
    if (block.arrangement.index() != 0) fail_at(node, "a block has at most one of line, grid, lattice and file");
    if (table.get("line") == &node) block.arrangement = line(node, numbers);
    if (table.get("grid") == &node) block.arrangement = grid(node, numbers);
    if (table.get("file") == &node) block.arrangement = listed(node, files);
    if (table.get("lattice") == &node) block.arrangement = crystal(node, numbers);
}

void read_displacement(ParticleBlock& block, const toml::node& node, SceneNumbers& numbers) {
    if (!node.is_table()) {
        block.displacement = numbers.vector(node, Use::start);
        return;
    }
    RandomDisplacement random;
    read_keys(table_of(node, "displacement"), "displacement",
              {{"random", [&](const toml::node& given) { random.width = numbers.not_negative(given, Use::start); }},
               {"seed", [&](const toml::node& given) { random.seed = numbers.seed(given); }}});
    block.displacement = random;
}

Temperature temperature_of(const toml::node& node, SceneNumbers& numbers) {
    Temperature temperature;
    read_keys(table_of(node, "temperature"), "temperature",
              {{"kT", [&](const toml::node& given) { temperature.kT = numbers.not_negative(given, Use::start); }},
               {"seed", [&](const toml::node& given) { temperature.seed = numbers.seed(given); }},
               {"exact", [&](const toml::node& given) { temperature.exact = flag_of(given); }}});
    return temperature;
}

/// The values must be those of the potential.
void check_values_of(const PairTerm& term, const toml::table& table, const PotentialInfo& built_in) {
    std::vector<std::string_view> known(built_in.parameters.size());
    std::transform(built_in.parameters.begin(), built_in.parameters.end(), known.begin(),
                   [](const PotentialInfo::Parameter& parameter) { return parameter.name; });
    for (const auto& [name, quantity] : term.values) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            fail_at(*table.get(name), unknown_word("value", name, known, term.potential));
    }
    for (const PotentialInfo::Parameter& parameter : built_in.parameters) {
        const auto given = term.values.find(std::string(parameter.name));
        if (parameter.required && given == term.values.end())
            fail_at(table, fmt::format("the potential {} needs a value of {}", term.potential, parameter.name));
        if (parameter.positive && !(given->second.value > 0))
            fail_at(*table.get(parameter.name), fmt::format("{} must be > 0", parameter.name));
    }
}

/// A word that is neither a variable nor a parameter is meant as the name of a potential.
void check_is_expression(const PairTerm& term, const toml::node& potential, SceneNumbers& numbers) {
    const bool word = std::all_of(term.potential.begin(), term.potential.end(),
                                  [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-'; });
    const bool name = term.potential == "r" || numbers.parameter(term.potential, potential, Use::force).has_value();
    if (!word || name) return;
    std::array<std::string_view, BuiltInPotentials::infos.size()> known;
    std::transform(BuiltInPotentials::infos.begin(), BuiltInPotentials::infos.end(), known.begin(),
                   [](const PotentialInfo* info) { return info->name; });
    fail_at(potential, unknown_word("potential", term.potential, known));
}

/// What an expression names must be known, and every value of its block used.
template <class Term>
void read_expression(Term& term, const toml::table& table, const toml::node& potential,
                     std::span<const std::string_view> variables, SceneNumbers& numbers) {
    const Expression expression = expression_of(potential);
    const std::span<const std::string> names = expression.names();
    for (const std::string& name : names) {
        const bool variable = std::find(variables.begin(), variables.end(), name) != variables.end();
        if (variable || term.values.contains(name)) continue;
        const auto value = numbers.parameter(name, potential, Use::force);
        if (!value) {
            std::vector<std::string_view> known(variables.begin(), variables.end());
            for (const auto& [own, quantity] : term.values) known.push_back(own);
            const std::vector<std::string_view> parameters = numbers.names();
            known.insert(known.end(), parameters.begin(), parameters.end());
            fail_at(potential, unknown_word("name", name, known));
        }
        term.parameters.emplace(name, *value);
    }
    for (const auto& [name, quantity] : term.values) {
        const bool variable = std::find(variables.begin(), variables.end(), name) != variables.end();
        if (variable || std::find(names.begin(), names.end(), name) == names.end())
            fail_at(*table.get(name), fmt::format("the potential does not use '{}'", shown(name)));
    }
    try {
        steplab::expression_of(term, 1);
    } catch (const UsageError& error) {
        fail_at(potential, error.what());
    }
}

}  // namespace

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

ParticleBlock particle_block(const toml::table& table, SceneNumbers& numbers, ParticleFiles& files) {
    ParticleBlock block;
    const auto arrangement = [&](const toml::node& node) { read_arrangement(table, block, node, numbers, files); };
    read_keys(table, "[[particles]]",
              {{"group", [&](const toml::node& node) { block.group = group_name(node); }},
               {"position", [&](const toml::node& node) { block.position = numbers.vector(node, Use::start); }},
               {"velocity", [&](const toml::node& node) { block.velocity = numbers.vector(node, Use::start); }},
               {"mass", [&](const toml::node& node) { block.mass = numbers.positive(node, Use::force); }},
               {"charge", [&](const toml::node& node) { block.charge = numbers.quantity(node, Use::force); }},
               {"fixed", [&](const toml::node& node) { block.fixed = flag_of(node); }},
               {"role", [&](const toml::node& node) { block.role = role_of(node); }},
               {"line", arrangement},
               {"grid", arrangement},
               {"lattice", arrangement},
               {"file", arrangement},
               {"displacement", [&](const toml::node& node) { read_displacement(block, node, numbers); }},
               {"temperature", [&](const toml::node& node) { block.temperature = temperature_of(node, numbers); }}});
    if (block.role == Role::fixed) block.fixed = fixed_by_role(table);
    settle_listed(table, block);
    return block;
}

Fix fix_of(const toml::table& table, SceneNumbers& numbers) {
    Fix fix;
    read_keys(table, "[[fix]]",
              {{"particles", [&](const toml::node& node) { fix.particles = texts_of(node); }},
               {"fixed", [&](const toml::node& node) { fix.fixed = flag_of(node); }},
               {"velocity", [&](const toml::node& node) { fix.velocity = numbers.vector(node, Use::start); }},
               {"displacement", [&](const toml::node& node) { fix.displacement = numbers.vector(node, Use::start); }},
               {"mass", [&](const toml::node& node) { fix.mass = numbers.positive(node, Use::force); }},
               {"charge", [&](const toml::node& node) { fix.charge = numbers.quantity(node, Use::force); }},
               {"role", [&](const toml::node& node) { fix.role = role_of(node); }}});
    if (fix.particles.empty()) fail_at(table, "[[fix]] needs particles");
    if (fix.role == Role::fixed) fix.fixed = fixed_by_role(table);
    return fix;
}

SpringTerm spring_term(const toml::table& table, SceneNumbers& numbers) {
    SpringTerm term;
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
               {"k", [&](const toml::node& node) { term.k = numbers.not_negative(node, Use::force), has_k = true; }},
               {"length", [&](const toml::node& node) { term.length = numbers.not_negative(node, Use::force); }},
               {"damping", [&](const toml::node& node) { term.damping = numbers.not_negative(node, Use::force); }},
               {"quadratic", [&](const toml::node& node) { term.quadratic = numbers.quantity(node, Use::force); }},
               {"cubic", [&](const toml::node& node) { term.cubic = numbers.quantity(node, Use::force); }}});
    if (!has_k) fail_at(table, "[[springs]] needs k, the force constant");
    if (term.between.empty() && term.pairs.empty()) fail_at(table, "[[springs]] needs between or pairs");
    return term;
}

PairTerm pair_term(const toml::table& table, SceneNumbers& numbers) {
    PairTerm term;
    const toml::node* potential = nullptr;
    read_keys(table, "[[pairs]]",
              {{"between",
                [&](const toml::node& node) {
                    term.between = texts_of(node);
                    if (term.between.size() > 2) fail_at(node, "between takes one group or two");
                }},
               {"potential", [&](const toml::node& node) { term.potential = text_of(node), potential = &node; }},
               {"cutoff", [&](const toml::node& node) { term.cutoff = numbers.positive(node, Use::force); }}},
              [&](const std::string& name, const toml::node& node) {
                  term.values[name] = numbers.quantity(node, Use::force);
              });
    if (!potential) fail_at(table, "[[pairs]] needs a potential");
    if (const PotentialInfo* const built_in = built_in_potential(term.potential)) {
        check_values_of(term, table, *built_in);
    } else {
        check_is_expression(term, *potential, numbers);
        read_expression(term, table, *potential, variables_of_pairs(), numbers);
    }
    return term;
}

FieldTerm field_term(const toml::table& table, SceneNumbers& numbers) {
    FieldTerm field;
    const toml::node* potential = nullptr;
    const auto value = [&](const std::string& name, const toml::node& node) {
        if (!table.contains("potential"))
            fail_at(node, unknown_word("key", name, {{"particles", "gravity", "drag", "potential"}}, "[[fields]]"));
        field.values[name] = numbers.quantity(node, Use::force);
    };
    read_keys(table, "[[fields]]",
              {{"particles", [&](const toml::node& node) { field.particles = texts_of(node); }},
               {"gravity", [&](const toml::node& node) { field.gravity = numbers.vector(node, Use::force); }},
               {"drag", [&](const toml::node& node) { field.drag = numbers.not_negative(node, Use::force); }},
               {"potential", [&](const toml::node& node) { field.potential = text_of(node), potential = &node; }}},
              value);
    if (potential) read_expression(field, table, *potential, variables_of_fields(), numbers);
    return field;
}

}  // namespace steplab
