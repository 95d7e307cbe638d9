#include "io/scene_toml.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_problems.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

namespace {

using Entry = std::pair<const toml::key*, const toml::node*>;

std::vector<Entry> in_file_order(const toml::table& table) {
    std::vector<Entry> entries;
    for (const auto& [key, node] : table) entries.emplace_back(&key, &node);
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.first->source().begin < b.first->source().begin; });
    return entries;
}

void read_key(const toml::key& key, const toml::node& node, std::string_view what,
              const std::vector<KeyHandler>& handlers,
              const std::function<void(const std::string&, const toml::node&)>& other) {
    const auto handler = std::find_if(handlers.begin(), handlers.end(),
                                      [name = key.str()](const KeyHandler& h) { return h.name == name; });
    if (handler != handlers.end()) return handler->read(node);
    if (other) return other(std::string(key.str()), node);
    std::vector<std::string_view> known(handlers.size());
    std::transform(handlers.begin(), handlers.end(), known.begin(), [](const auto& h) { return h.name; });
    throw SceneProblem(key.source().begin, unknown_word("key", std::string(key.str()), known, std::string(what)));
}

}  // namespace

void fail_in(const std::string& file, const toml::parse_error& error) {
    throw FileError(place_text(file, error.source().begin) + std::string(error.description()));
}

void fail_in(const std::string& file, const SceneProblem& problem) {
    throw FileError(place_text(file, problem.place()) + problem.what());
}

void fail_at(const toml::node& node, const std::string& message) { throw SceneProblem(node.source().begin, message); }

std::string place_text(const std::string& file, toml::source_position place) {
    return fmt::format("{}:{}:{}: ", shown(file), place.line, place.column);
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result + '"';
}

void read_keys(const toml::table& table, std::string_view what, const std::vector<KeyHandler>& handlers,
               const std::function<void(const std::string&, const toml::node&)>& other) {
    for (const auto& [key, node] : in_file_order(table)) read_key(*key, *node, what, handlers, other);
}

void read_all_keys(const toml::table& table, std::string_view what, const std::vector<KeyHandler>& handlers,
                   const std::function<void(const std::string&, const toml::node&)>& other) {
    SceneProblems problems;
    for (const auto& [key, node] : in_file_order(table))
        problems.attempt([&, k = key, n = node] { read_key(*k, *n, what, handlers, other); });
    problems.report();
}

void each_table(const toml::table& root, std::string_view name, const std::function<void(const toml::table&)>& visit) {
    const toml::node* const node = root.get(name);
    if (!node) return;
    if (const toml::table* const single = node->as_table()) return visit(*single);
    const toml::array* const array = node->as_array();
    if (!array) fail_at(*node, fmt::format("{} must be written as [[{}]]", name, name));
    for (const toml::node& element : *array) visit(table_of(element, fmt::format("[[{}]]", name)));
}

std::string text_of(const toml::node& node) {
    if (const auto* const text = node.as_string()) return text->get();
    fail_at(node, "must be a text in quotation marks");
}

std::string word_of(const toml::node& node, std::string_view what, std::vector<std::string_view> known) {
    std::string word = text_of(node);
    if (std::find(known.begin(), known.end(), word) == known.end()) fail_at(node, unknown_word(what, word, known));
    return word;
}

bool flag_of(const toml::node& node) {
    if (const auto* const flag = node.as_boolean()) return flag->get();
    fail_at(node, "must be true or false");
}

const toml::table& table_of(const toml::node& node, std::string_view what) {
    if (const toml::table* const table = node.as_table()) return *table;
    fail_at(node, fmt::format("{} must be a table", what));
}

std::vector<const toml::node*> elements_of(const toml::node& node, std::string_view what, std::size_t least,
                                           std::size_t most) {
    const toml::array* const array = node.as_array();
    if (!array || array->size() < least || array->size() > most) fail_at(node, fmt::format("must be {}", what));
    std::vector<const toml::node*> elements;
    for (const toml::node& element : *array) elements.push_back(&element);
    return elements;
}

}  // namespace steplab
