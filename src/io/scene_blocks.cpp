#include "io/scene_blocks.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_problems.hpp"
#include "models/potentials/list.hpp"
#include "models/scene/potential_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;

/// The values must be those of the potential.
void check_values_of(const PairTerm& term, const toml::table& table, const PotentialInfo& built_in) {
    std::vector<std::string_view> known(built_in.parameters.size());
    std::transform(built_in.parameters.begin(), built_in.parameters.end(), known.begin(),
                   [](const PotentialInfo::Parameter& parameter) { return parameter.name; });
    SceneProblems problems;
    for (const auto& given : term.values) {
        const std::string& name = given.first;
        if (std::find(known.begin(), known.end(), name) == known.end())
            problems.attempt([&] { fail_at(*table.get(name), unknown_word("value", name, known, term.potential)); });
    }
    for (const PotentialInfo::Parameter& parameter : built_in.parameters) {
        const auto given = term.values.find(std::string(parameter.name));
        if (parameter.positive && given != term.values.end() && !(given->second.value > 0))
            problems.attempt(
                [&] { fail_at(*table.get(parameter.name), fmt::format("{} must be > 0", parameter.name)); });
    }
    problems.report();
    for (const PotentialInfo::Parameter& parameter : built_in.parameters) {
        if (parameter.required && !term.values.contains(std::string(parameter.name)))
            fail_at(table, fmt::format("the potential {} needs a value of {}", term.potential, parameter.name));
    }
}

/// A word that is neither a variable nor a parameter is meant as the name of a potential.
void check_is_expression(const PairTerm& term, const toml::node& potential, SceneNumbers& numbers) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const bool word = !term.potential.starts_with('-') && std::all_of(term.potential.begin(), term.potential.end(),
                                                                      [&](char c) { return is_letter(c) || c == '-'; });
    const bool name = term.potential == "r" || term.potential == "pi" ||
                      numbers.parameter(term.potential, potential, Use::force).has_value();
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
    SceneProblems unused;
    for (const auto& given : term.values) {
        const std::string& name = given.first;
        const bool variable = std::find(variables.begin(), variables.end(), name) != variables.end();
        if (variable || std::find(names.begin(), names.end(), name) == names.end())
            unused.attempt(
                [&] { fail_at(*table.get(name), fmt::format("the potential does not use '{}'", shown(name))); });
    }
    unused.report();
    try {
        steplab::expression_of(term, 1);
    } catch (const UsageError& error) {
        fail_at(potential, error.what());
    }
}

}  // namespace

Role role_at(const toml::node& node) {
    const std::string word = word_of(node, "role", {"moving", "fixed", "kicked", "bullet"});
    return word == "kicked"   ? Role::kicked
           : word == "bullet" ? Role::bullet
           : word == "fixed"  ? Role::fixed
                              : Role::moving;
}

bool fixed_by_role(const toml::table& table) {
    const toml::node* const fixed = table.get("fixed");
    if (fixed && !flag_of(*fixed))
        fail_at(*table.get("role"), "a particle of the role \"fixed\" is fixed: leave the role out, or fixed = false");
    return true;
}

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

Fix fix_of(const toml::table& table, SceneNumbers& numbers) {
    Fix fix;
    read_all_keys(
        table, "[[fix]]",
        {{"particles", [&](const toml::node& node) { fix.particles = texts_of(node); }},
         {"fixed", [&](const toml::node& node) { fix.fixed = flag_of(node); }},
         {"velocity", [&](const toml::node& node) { fix.velocity = numbers.vector(node, Use::start); }},
         {"displacement", [&](const toml::node& node) { fix.displacement = numbers.vector(node, Use::start); }},
         {"mass", [&](const toml::node& node) { fix.mass = numbers.positive(node, Use::force); }},
         {"charge", [&](const toml::node& node) { fix.charge = numbers.quantity(node, Use::force); }},
         {"role", [&](const toml::node& node) { fix.role = role_at(node); }}});
    if (fix.particles.empty()) fail_at(table, "[[fix]] needs particles");
    if (table.size() == 1)
        fail_at(table, "[[fix]] sets nothing: give fixed, velocity, displacement, mass, charge or role");
    if (fix.role == Role::fixed) fix.fixed = fixed_by_role(table);
    return fix;
}

namespace {

/// Reads a block in which every key that is not given here is a value of its potential.
void read_potential(PairTerm& term, const toml::table& table, std::string_view what, std::vector<KeyHandler> keys,
                    SceneNumbers& numbers) {
    keys.push_back({"potential", [&](const toml::node& node) { term.potential = text_of(node); }});
    read_all_keys(table, what, keys, [&](const std::string& name, const toml::node& node) {
        term.values[name] = numbers.quantity(node, Use::force);
    });
}

/// The potential must be known, or an expression, and its values those that it takes.
void check_potential(PairTerm& term, const toml::table& table, SceneNumbers& numbers) {
    const toml::node& potential = *table.get("potential");
    if (const PotentialInfo* const built_in = built_in_potential(term.potential)) {
        check_values_of(term, table, *built_in);
    } else {
        check_is_expression(term, potential, numbers);
        read_expression(term, table, potential, variables_of_pairs(), numbers);
    }
}

/// The keys of a block of springs that say where they are.
std::vector<KeyHandler> places_of(SpringTerm& term) {
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
    return {
        {"between", [&](const toml::node& node) { term.between = text_of(node); }}, {"along", along}, {"pairs", pairs}};
}

PairTerm potential_of_springs(const toml::table& table, std::vector<KeyHandler> keys, SceneNumbers& numbers) {
    PairTerm potential;
    read_potential(potential, table, "[[springs]]", std::move(keys), numbers);
    check_potential(potential, table, numbers);
    return potential;
}

/// F = -(k e + quadratic e^2 + cubic e^3).
void read_spring_law(SpringTerm& term, const toml::table& table, std::vector<KeyHandler> keys, SceneNumbers& numbers) {
    bool has_k = false;
    const std::vector<KeyHandler> own{
        {"k", [&](const toml::node& node) { term.k = numbers.not_negative(node, Use::force), has_k = true; }},
        {"length", [&](const toml::node& node) { term.length = numbers.not_negative(node, Use::force); }},
        {"quadratic", [&](const toml::node& node) { term.quadratic = numbers.quantity(node, Use::force); }},
        {"cubic", [&](const toml::node& node) { term.cubic = numbers.quantity(node, Use::force); }},
        // known already: named where a key is not
        {"potential", [](const toml::node&) {}}};
    keys.insert(keys.end(), own.begin(), own.end());
    read_all_keys(table, "[[springs]]", keys);
    if (!has_k) fail_at(table, "[[springs]] needs k, the force constant, or a potential");
}

}  // namespace

SpringTerm spring_term(const toml::table& table, SceneNumbers& numbers) {
    SpringTerm term;
    std::vector<KeyHandler> keys = places_of(term);
    keys.push_back({"damping", [&](const toml::node& node) { term.damping = numbers.not_negative(node, Use::force); }});
    if (table.contains("potential"))
        term.potential = potential_of_springs(table, std::move(keys), numbers);
    else
        read_spring_law(term, table, std::move(keys), numbers);
    if (term.between.empty() && term.pairs.empty()) fail_at(table, "[[springs]] needs between or pairs");
    return term;
}

PairTerm pair_term(const toml::table& table, SceneNumbers& numbers) {
    PairTerm term;
    const auto between = [&](const toml::node& node) {
        term.between = texts_of(node);
        if (term.between.size() > 2) fail_at(node, "between takes one group or two");
    };
    read_potential(term, table, "[[pairs]]",
                   {{"between", between},
                    {"cutoff", [&](const toml::node& node) { term.cutoff = numbers.positive(node, Use::force); }}},
                   numbers);
    if (!table.contains("potential")) fail_at(table, "[[pairs]] needs a potential");
    check_potential(term, table, numbers);
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
    read_all_keys(table, "[[fields]]",
                  {{"particles", [&](const toml::node& node) { field.particles = texts_of(node); }},
                   {"gravity", [&](const toml::node& node) { field.gravity = numbers.vector(node, Use::force); }},
                   {"drag", [&](const toml::node& node) { field.drag = numbers.not_negative(node, Use::force); }},
                   {"potential", [&](const toml::node& node) { field.potential = text_of(node), potential = &node; }}},
                  value);
    if (!potential && !field.gravity && !field.drag)
        fail_at(table, "[[fields]] does nothing: give gravity, drag or a potential");
    if (potential) read_expression(field, table, *potential, variables_of_fields(), numbers);
    return field;
}

}  // namespace steplab
