#pragma once

#include "core/expression.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <utility>
#include <vector>

namespace steplab {

/// What is wrong with a scene file, and where.
class SceneProblem : public std::runtime_error {
public:
    SceneProblem(toml::source_position place, const std::string& message)
        : std::runtime_error(message), place_(place) {}
    toml::source_position place() const { return place_; }

private:
    toml::source_position place_;
};

/// The error of a file whose text is no TOML, or has something wrong in it: "FILE:LINE:COLUMN: what is wrong".
[[noreturn]] void fail_in(const std::string& file, const toml::parse_error& error);
[[noreturn]] void fail_in(const std::string& file, const SceneProblem& problem);

/// Calls `work`, which reads the TOML text of a file. What is wrong there is thrown as FileError with its place.
template <class Work>
auto in_file(const std::string& file, const Work& work) {
    try {
        return work();
    } catch (const toml::parse_error& error) {
        fail_in(file, error);
    } catch (const SceneProblem& problem) {
        fail_in(file, problem);
    }
}

[[noreturn]] void fail_at(const toml::node& node, const std::string& message);

/// "FILE:LINE:COLUMN: ", with which a message about a file begins.
std::string place_text(const std::string& file, toml::source_position place);

/// A text in quotation marks, on one line.
std::string toml_string(std::string_view text);

/// A key of a table and what is to be done with its value.
struct KeyHandler {
    std::string_view name;
    std::function<void(const toml::node&)> read;
};

/// Reads the keys of a table in the order of the file. `other` takes those that have no handler; without it they are an
/// error that names the nearest one. Throws SceneProblem.
void read_keys(const toml::table& table, std::string_view what, const std::vector<KeyHandler>& handlers,
               const std::function<void(const std::string&, const toml::node&)>& other = {});
/// The same, but what is wrong is thrown when all keys have been read: the first of it in the file, although it may be
/// within the value of a key that is read early, or noticed late.
void read_all_keys(const toml::table& table, std::string_view what, const std::vector<KeyHandler>& handlers,
                   const std::function<void(const std::string&, const toml::node&)>& other = {});

/// The tables of an array of tables, [[name]]; one table counts as an array of one.
void each_table(const toml::table& root, std::string_view name, const std::function<void(const toml::table&)>& visit);

// Values of one kind; anything else is an error that says what would be right.
std::string text_of(const toml::node& node);
std::string word_of(const toml::node& node, std::string_view what, std::vector<std::string_view> known);
bool flag_of(const toml::node& node);
const toml::table& table_of(const toml::node& node, std::string_view what);
/// The elements of an array, of which there are from `least` to `most`.
std::vector<const toml::node*> elements_of(const toml::node& node, std::string_view what, std::size_t least,
                                           std::size_t most);

}  // namespace steplab
