#include "core/error.hpp"
#include "io/scene_blocks.hpp"

#include <algorithm>

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

/// `spread`: displacements set the particles apart.
LineArrangement line(const toml::node& node, SceneNumbers& numbers, bool spread) {
    LineArrangement line{.count = 0, .step = {}};
    read_all_keys(table_of(node, "line"), "line",
                  {{"count", [&](const toml::node& given) { line.count = numbers.count(given, 1); }},
                   {"step", [&](const toml::node& given) { line.step = numbers.vector(given, Use::start); }}});
    if (line.count == 0) fail_at(node, "a line needs a count");
    if (line.count > 1 && !spread && !node.as_table()->contains("step"))
        fail_at(node, "a line needs a step, [x, y, z], from one particle to the next");
    return line;
}

GridArrangement grid(const toml::node& node, SceneNumbers& numbers, bool spread) {
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
    read_all_keys(table_of(node, "grid"), "grid", {{"count", count}, {"steps", steps}});
    if (grid.rows == 0) fail_at(node, "a grid needs a count");
    if (grid.columns * grid.rows > 1 && !spread && !node.as_table()->contains("steps"))
        fail_at(node, "a grid needs steps, [[x, y, z], [x, y, z]], along its rows and from row to row");
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
    read_all_keys(table_of(node, "lattice"), "lattice",
                  {{"kind", kind}, {"cells", cells}, {"constant", [&](const toml::node& given) {
                                                          crystal.constant = numbers.positive(given, Use::start);
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
    const bool spread = table.contains("displacement");
    if (table.get("line") == &node) block.arrangement = line(node, numbers, spread);
    if (table.get("grid") == &node) block.arrangement = grid(node, numbers, spread);
    if (table.get("file") == &node) block.arrangement = listed(node, files);
    if (table.get("lattice") == &node) block.arrangement = crystal(node, numbers);
}

void read_displacement(ParticleBlock& block, const toml::node& node, SceneNumbers& numbers) {
    if (!node.is_table()) {
        block.displacement = numbers.vector(node, Use::start);
        return;
    }
    RandomDisplacement random;
    read_all_keys(table_of(node, "displacement"), "displacement",
                  {{"random", [&](const toml::node& given) { random.width = numbers.not_negative(given, Use::start); }},
                   {"seed", [&](const toml::node& given) { random.seed = numbers.seed(given); }}});
    if (!node.as_table()->contains("random"))
        fail_at(node, "a displacement needs random, the largest one along each axis, or is a vector [x, y, z]");
    block.displacement = random;
}

Temperature temperature_of(const toml::node& node, SceneNumbers& numbers) {
    Temperature temperature;
    read_all_keys(table_of(node, "temperature"), "temperature",
                  {{"kT", [&](const toml::node& given) { temperature.kT = numbers.not_negative(given, Use::start); }},
                   {"seed", [&](const toml::node& given) { temperature.seed = numbers.seed(given); }},
                   {"exact", [&](const toml::node& given) { temperature.exact = flag_of(given); }}});
    if (!node.as_table()->contains("kT")) fail_at(node, "a temperature needs kT");
    return temperature;
}

}  // namespace

ParticleBlock particle_block(const toml::table& table, SceneNumbers& numbers, ParticleFiles& files) {
    ParticleBlock block;
    const auto arrangement = [&](const toml::node& node) { read_arrangement(table, block, node, numbers, files); };
    read_all_keys(
        table, "[[particles]]",
        {{"group", [&](const toml::node& node) { block.group = group_name(node); }},
         {"position", [&](const toml::node& node) { block.position = numbers.vector(node, Use::start); }},
         {"velocity", [&](const toml::node& node) { block.velocity = numbers.vector(node, Use::start); }},
         {"mass", [&](const toml::node& node) { block.mass = numbers.positive(node, Use::force); }},
         {"charge", [&](const toml::node& node) { block.charge = numbers.quantity(node, Use::force); }},
         {"fixed", [&](const toml::node& node) { block.fixed = flag_of(node); }},
         {"role", [&](const toml::node& node) { block.role = role_at(node); }},
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

}  // namespace steplab
