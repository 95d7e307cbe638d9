#pragma once

#include "core/entry.hpp"
#include "core/expression.hpp"
#include "io/scene_problems.hpp"
#include "io/scene_toml.hpp"
#include "models/scene/written_number.hpp"

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace steplab {

/// The [parameters] of a scene file. Those given as numbers are parameters of the scene, those given as expressions
/// follow them.
class SceneParameters {
public:
    struct Entry {
        const toml::node* place = nullptr;  ///< of its value
        double number = 0;
        std::optional<Expression> expression = {};
        ParameterInfo info = {};
        const toml::node* range = nullptr;         ///< as the file gives it
        const toml::node* logarithmic = nullptr;   ///< where the file says so
        std::optional<SceneProblem> problem = {};  ///< with which it has no value
    };

    SceneParameters() = default;
    /// What is wrong is added to the problems, and thrown where such a parameter is used.
    SceneParameters(const toml::table& root, SceneProblems& problems);

    const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }
    /// What is known of each that is a number, in the order of the file; valid as long as this object.
    const std::vector<ParameterInfo>& infos() const { return infos_; }
    /// Whether changes of a parameter make the scene start again.
    void on_change(std::string_view name, OnChange change);
    /// One that is a count by itself takes whole numbers from `least` on.
    void counts(std::string_view name, std::size_t least);

private:
    void read(Entry& entry, const std::string& name, const toml::node& node);
    void set_range(Entry& entry);
    void read_value(Entry& entry, const toml::node& node);
    std::string_view kept(std::string text);

    std::map<std::string, Entry, std::less<>> entries_;
    std::vector<ParameterInfo> infos_;
    std::deque<std::string> texts_;
};

/// The parsed text of a node. Throws SceneProblem.
Expression expression_of(const toml::node& node);

/// Turns the numbers and expressions of a scene file into quantities, and notes which parameters they use.
class SceneNumbers {
public:
    enum class Use { force, start };

    /// The values of those that are numbers.
    SceneNumbers(const SceneParameters& parameters, const ParameterValues& values);

    /// A number or an expression. Throws SceneProblem.
    WrittenNumber quantity(const toml::node& node, Use use);
    WrittenNumber positive(const toml::node& node, Use use);
    WrittenNumber not_negative(const toml::node& node, Use use);
    WrittenVector vector(const toml::node& node, Use use);
    /// A whole number from `least` on.
    std::size_t count(const toml::node& node, std::size_t least);
    std::uint64_t seed(const toml::node& node);
    /// The value of a parameter that a potential uses; nothing if there is none of this name.
    std::optional<double> parameter(const std::string& name, const toml::node& place, Use use);
    std::vector<std::string_view> names() const;
    const ParameterValues& values() const { return values_; }
    /// The parameters that are expressions, as they are written.
    std::map<std::string, std::string> followers() const;

    const std::map<std::string, Use, std::less<>>& used() const { return used_; }
    /// Parameters that are counts by themselves, `count = "n"`, and the least one.
    const std::map<std::string, std::size_t, std::less<>>& counting() const { return counting_; }

    /// Numbers that a run in float would not have.
    const SceneProblems& lost_in_float() const { return lost_in_float_; }

    static constexpr double largest_count = 4294967295.0;

private:
    void uses(std::string_view parameter, Use use);
    void note_float(const toml::node& node, double value, Use use);
    bool is_count_alone(const toml::node& node, std::size_t least);
    double value_of(const std::string& name, const toml::node& place);
    double evaluated(const Expression& expression, const toml::node& place);

    const SceneParameters& parameters_;
    const ParameterValues& values_;
    std::map<std::string, double, std::less<>> known_;
    std::set<std::string, std::less<>> under_way_;
    std::map<std::string, Use, std::less<>> used_;
    std::map<std::string, std::size_t, std::less<>> counting_;
    SceneProblems lost_in_float_;
};

}  // namespace steplab
