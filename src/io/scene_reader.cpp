#include "io/scene_reader.hpp"

#include "io/scene_appearance.hpp"
#include "io/scene_blocks.hpp"
#include "io/scene_checks.hpp"
#include "io/scene_defaults.hpp"
#include "models/scene/finite_start.hpp"
#include "models/scene/scene_particles.hpp"

#include <string_view>
#include <vector>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;

/// The blocks of one kind, each with its place.
template <class Block>
struct Blocks {
    std::vector<Block>& read;
    std::vector<const toml::table*> tables = {};
    bool complete = true;  ///< all of the file could be read
};

/// Reads the blocks of a file, each with its place.
class Reader {
public:
    Reader(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files, const SceneReading& how,
           SceneProblems& problems)
        : root_(root), numbers_(numbers), files_(files), how_(how), problems_(problems) {}

    Scene scene() {
        read_blocks();
        if (how_.checks) check_meaning();
        return std::move(scene_);
    }

private:
    void read_blocks();
    template <class Block, class Read>
    void read(std::string_view name, Blocks<Block>& blocks, const Read& read);
    void read_box();
    void check_meaning();
    void check_starts();

    const toml::table& root_;
    SceneNumbers& numbers_;
    ParticleFiles& files_;
    const SceneReading& how_;
    SceneProblems& problems_;
    Scene scene_;
    Blocks<ParticleBlock> blocks_{scene_.particles};
    Blocks<Fix> fixes_{scene_.fixes};
    Blocks<SpringTerm> springs_{scene_.springs};
    Blocks<PairTerm> pairs_{scene_.pairs};
    Blocks<FieldTerm> fields_{scene_.fields};
};

template <class Block, class Read>
void Reader::read(std::string_view name, Blocks<Block>& blocks, const Read& read) {
    SceneProblems problems;
    problems.attempt([&] {
        each_table(root_, name, [&](const toml::table& table) {
            problems.attempt([&] {
                blocks.read.push_back(read(table));
                blocks.tables.push_back(&table);
            });
        });
    });
    blocks.complete = !problems.any();
    problems_.attempt([&] { problems.report(); });
}

void Reader::read_blocks() {
    read("particles", blocks_, [this](const toml::table& table) { return particle_block(table, numbers_, files_); });
    const auto of = [this](auto block) {
        return [this, block](const toml::table& table) { return block(table, numbers_); };
    };
    read("fix", fixes_, of(fix_of));
    read("springs", springs_, of(spring_term));
    read("pairs", pairs_, of(pair_term));
    read("fields", fields_, of(field_term));
    problems_.attempt([&] {
        if (const toml::node* const start = root_.get("start")) scene_.start = scene_start(*start, numbers_, files_);
    });
    problems_.attempt([&] { read_box(); });
    if (scene_.particles.empty() && blocks_.complete)
        problems_.attempt([&] { fail_at(root_, "a scene needs [[particles]]"); });
    // before anything goes through particles
    SceneProblems memory;
    memory.attempt([&] { check_memory(blocks_.tables, scene_, how_); });
    blocks_.complete = blocks_.complete && !memory.any() && !scene_.particles.empty();
    problems_.attempt([&] { memory.report(); });
}

void Reader::read_box() {
    const toml::node* const box = root_.get("box");
    if (!box) return;
    const auto size = [&](const toml::node& node) {
        const auto sides = elements_of(node, "three lengths, [x, y, z]", 3, 3);
        scene_.box = {numbers_.not_negative(*sides[0], Use::start), numbers_.not_negative(*sides[1], Use::start),
                      numbers_.not_negative(*sides[2], Use::start)};
    };
    const toml::table& table = table_of(*box, "[box]");
    read_all_keys(table, "[box]", {{"size", size}, {"corner", [&](const toml::node& node) {
                                                        scene_.corner = numbers_.vector(node, Use::start);
                                                    }}});
    if (!table.contains("size")) fail_at(table, "[box] needs a size, [x, y, z]; 0: no boundary along this axis");
}

void Reader::check_meaning() {
    check_groups(root_, problems_);
    if (!blocks_.complete) return;  // how many particles there are is not known
    const SceneParticles particles(scene_, SceneParticles::Ask::names);
    for (const toml::table* const table : fixes_.tables) check_names(*table, particles, problems_);
    problems_.attempt([&] { check_start(root_, scene_.start, particles.count()); });
    for (std::size_t i = 0; i < springs_.tables.size(); ++i)
        check_springs(*springs_.tables[i], scene_.springs[i], particles, problems_);
    for (std::size_t i = 0; i < pairs_.tables.size(); ++i)
        check_pairs(*pairs_.tables[i], scene_.pairs[i], scene_.box.value(), particles, problems_);
    for (const toml::table* const table : fields_.tables) check_names(*table, particles, problems_);
    if (!problems_.any() && !how_.starts_are_known) check_starts();
}

/// Unless a file says where the particles start.
void Reader::check_starts() {
    if (scene_.start.change.from) return;
    const SceneParticles particles(scene_, SceneParticles::Ask::places);
    for (std::size_t i = 0; i < springs_.tables.size(); ++i) {
        const toml::node* const potential = springs_.tables[i]->get("potential");
        if (potential)
            problems_.attempt_at(*potential, [&] { check_finite(scene_.springs[i], particles, scene_.box.value()); });
    }
    for (std::size_t i = 0; i < pairs_.tables.size(); ++i)
        problems_.attempt_at(*pairs_.tables[i]->get("potential"),
                             [&] { check_finite(scene_.pairs[i], particles, scene_.box.value()); });
    for (std::size_t i = 0; i < fields_.tables.size(); ++i) {
        const toml::node* const potential = fields_.tables[i]->get("potential");
        if (potential) problems_.attempt_at(*potential, [&] { check_finite(scene_.fields[i], particles); });
    }
}

}  // namespace

Scene read_scene(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files, const SceneReading& how,
                 SceneProblems& problems) {
    Scene scene = Reader(root, numbers, files, how, problems).scene();
    scene.followers = numbers.followers();
    return scene;
}

SceneTexts read_texts(const toml::table& root, SceneNumbers& numbers, SceneProblems& problems) {
    SceneTexts texts;
    const auto ignore = [](const toml::node&) {};
    const auto version = [&](const toml::node& node) {
        const auto* const number = node.as_integer();
        if (!number || number->get() != 1) fail_at(node, "this program reads version 1: steplab = 1");
    };
    if (const toml::node* const node = root.get("steplab"))
        version(*node);
    else
        throw SceneProblem({1, 1}, "a scene file begins with its version: steplab = 1");
    const auto read = [&] {
        read_all_keys(root, "a scene file",
                      {{"steplab", ignore},
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
    };
    problems.attempt(read);
    return texts;
}

}  // namespace steplab
