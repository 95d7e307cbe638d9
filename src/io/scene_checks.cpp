#include "io/scene_checks.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "models/scene/spring_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// Calls visit(node, text) for each text of a key, which is one or a list of them; whole numbers are left out.
template <class Visit>
void each_text(const toml::node* key, const Visit& visit) {
    if (!key) return;
    const auto one = [&](const toml::node& node) {
        if (const auto* const text = node.as_string()) visit(node, std::string_view(text->get()));
    };
    const toml::array* const list = key->as_array();
    if (!list) return one(*key);
    for (const toml::node& element : *list) one(element);
}

/// "rope" of "rope[2-5]"; empty for numbers and all, which name no group.
std::string_view group_in(std::string_view text) {
    const std::string_view name = text.substr(0, text.find('['));
    const bool number = name.find_first_not_of("0123456789-") == std::string_view::npos;
    return number || name == "all" ? std::string_view() : name;
}

void check_group(const toml::node& node, std::string_view text, const std::set<std::string, std::less<>>& groups) {
    const std::string_view name = group_in(text);
    if (name.empty() || groups.contains(name)) return;
    const std::vector<std::string_view> known(groups.begin(), groups.end());
    fail_at(node, unknown_word("group", name, known));
}

/// The spring joins single particles that are two.
void check_pair(const SpringTerm& term, std::size_t number, const SceneParticles& particles) {
    const auto& [one, other] = term.pairs[number];
    const IndexRange first = particles.named(one), second = particles.named(other);
    if (first.count != 1 || second.count != 1)
        throw UsageError(
            fmt::format("a spring joins single particles: '{}' and '{}' name more", shown(one), shown(other)));
    if (first.first == second.first) throw UsageError(fmt::format("a spring from '{}' to itself", shown(one)));
}

/// A group whose neighbours a spring can join.
void check_between(const toml::table& table, const SpringTerm& term, const SceneParticles& particles) {
    const SceneParticles::Group group = particles.group(term.between);
    const std::string name = shown(term.between);
    const auto* const grid = std::get_if<GridArrangement>(&group.block.arrangement);
    if (std::holds_alternative<CrystalArrangement>(group.block.arrangement))
        throw UsageError(
            fmt::format("group '{}' is a lattice, whose rows end within its numbers: springs join the "
                        "neighbours of a line or a grid; here name them, pairs = [[\"{}[0]\", \"{}[1]\"]]",
                        name, name, name));
    const toml::node* const along = table.get("along");
    if (along && !grid)
        fail_at(*along,
                fmt::format("group '{}' is no grid: its springs join the neighbours of a line; leave along out", name));
    if (group.particles.count < 2)
        throw UsageError(fmt::format("group '{}' has one particle, which has no neighbours", name));
    if (term.along == SpringTerm::Along::diagonals && (grid->columns < 2 || grid->rows < 2))
        fail_at(*along,
                fmt::format("a grid of {} x {} particles has no diagonals: along = \"axes\" joins its neighbours",
                            grid->columns, grid->rows));
}

double side_at_least(double cutoff) { return 2.3 * cutoff; }

void check_box(const PairTerm& term, Vec3 box) {
    for (const double side : {box.x, box.y, box.z}) {
        if (side == 0) continue;
        if (!term.cutoff) throw UsageError("in a periodic box every pair force needs a cutoff");
        const double least = side_at_least(term.cutoff->value);
        if (side < least)
            throw UsageError(fmt::format("the box is {} long: 2.3 times the cutoff, {}, must fit into it",
                                         exact_text(side), exact_text(least)));
    }
}

/// The number that says how many there are.
const toml::node& count_in(const toml::table& block) {
    for (const auto& [key, number] : {std::pair("line", "count"), {"grid", "count"}, {"lattice", "cells"}}) {
        const toml::node* const found = block[key][number].node();
        if (found) return *found;
    }
    return block;
}

}  // namespace

void check_groups(const toml::table& root, SceneProblems& problems) {
    std::set<std::string, std::less<>> groups;
    const auto tables = [&](std::string_view name, const auto& visit) {
        problems.attempt([&] { each_table(root, name, visit); });
    };
    tables("particles", [&](const toml::table& table) {
        each_text(table.get("group"), [&](const toml::node& node, std::string_view name) {
            if (groups.insert(std::string(name)).second) return;
            problems.attempt([&] { fail_at(node, fmt::format("there is a group '{}' already", shown(name))); });
        });
    });
    const auto known = [&](const toml::node& node, std::string_view text) {
        problems.attempt([&] { check_group(node, text, groups); });
    };
    for (const char* const name : {"fix", "springs", "pairs", "fields"}) {
        tables(name, [&](const toml::table& table) {
            for (const char* const key : {"particles", "between"}) each_text(table.get(key), known);
            const toml::array* const pairs = table["pairs"].as_array();
            if (!pairs) return;
            for (const toml::node& pair : *pairs)
                each_text(&pair, [&](const toml::node&, std::string_view text) { known(pair, text); });
        });
    }
}

void check_names(const toml::table& table, const SceneParticles& particles, SceneProblems& problems) {
    const auto check = [&](const toml::node& node) {
        const std::string text = node.is_string() ? text_of(node) : std::to_string(node.value_or<std::int64_t>(0));
        problems.attempt_at(node, [&] { particles.named(text); });
    };
    for (const char* const key : {"particles", "between"}) {
        const toml::node* const node = table.get(key);
        const toml::array* const list = node ? node->as_array() : nullptr;
        if (!list) {
            if (node) check(*node);
            continue;
        }
        for (const toml::node& element : *list) check(element);
    }
}

void check_springs(const toml::table& table, const SpringTerm& term, const SceneParticles& particles,
                   SceneProblems& problems) {
    if (!term.between.empty())
        problems.attempt_at(*table.get("between"), [&] { check_between(table, term, particles); });
    else if (const toml::node* const along = table.get("along"))
        problems.attempt_at(*along, [] { throw UsageError("along is a direction in a grid: name it, between"); });
    for (std::size_t i = 0; i < term.pairs.size(); ++i)
        problems.attempt_at(*table["pairs"][i].node(), [&] { check_pair(term, i, particles); });
}

void check_pairs(const toml::table& table, const PairTerm& term, Vec3 box, const SceneParticles& particles,
                 SceneProblems& problems) {
    const auto place = [&](const char* key) -> const toml::node& {
        const toml::node* const node = table.get(key);
        return node ? *node : table;
    };
    SceneProblems names;
    check_names(table, particles, names);
    if (names.any()) return problems.attempt([&] { names.report(); });
    problems.attempt_at(place("between"), [&] {
        const IndexRange all{0, particles.count()};
        const IndexRange first = term.between.empty() ? all : particles.named(term.between.front());
        const IndexRange second = term.between.empty() ? all : particles.named(term.between.back());
        if (first == second && first.count < 2) throw UsageError("a pair force within one particle acts on nothing");
    });
    problems.attempt_at(place("cutoff"), [&] { check_box(term, box); });
}

void check_memory(const std::vector<const toml::table*>& blocks, const Scene& scene, const SceneReading& how) {
    double particles = 0, most = 0;
    const toml::table* largest = nullptr;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const auto count = static_cast<double>(scene.particles[i].count());
        particles += count;
        if (!(count > most)) continue;
        most = count;
        largest = blocks[i];
    }
    const double needed = particles * how.bytes_per_particle;
    if (needed <= how.memory && particles <= 4294967295.0) return;
    fail_at(count_in(*largest), fmt::format("{} particles need {} of memory, {} are available: choose fewer",
                                            exact_text(particles), bytes_text(needed), bytes_text(how.memory)));
}

}  // namespace steplab
