#include "tables.hpp"

#include "io/temporary_folder.hpp"
#include "lab/study/thesis.hpp"
#include "shell.hpp"
#include "sim/catalogue.hpp"
#include "speed.hpp"
#include "ui/keys.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace steplab::docs {
namespace {

std::string default_text(const ParameterInfo& info) {
    return fmt::format("{}{}{}", format_value(info, info.default_value), info.unit.empty() ? "" : " ", info.unit);
}

/// "n = 10, k = 1 N/m": the parameters with their defaults.
std::string defaults_text(std::span<const ParameterInfo> parameters) {
    std::string text;
    for (const ParameterInfo& info : parameters) {
        text += fmt::format("{}`{}` = {}", text.empty() ? "" : ", ", info.name, default_text(info));
    }
    return text.empty() ? "none" : text;
}

std::string parameter_table(std::span<const ParameterInfo> parameters) {
    if (parameters.empty()) return "It has no parameters.\n";
    std::string table = "| parameter | meaning | unit | range | default | when changed |\n|---|---|---|---|---|---|\n";
    for (const ParameterInfo& info : parameters) {
        table += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", info.name, info.what, info.unit, range_text(info),
                             format_value(info, info.default_value),
                             info.on_change == OnChange::applies_live ? "takes effect at once" : "restarts the run");
    }
    return table;
}

std::string order_text(const MethodInfo& info) {
    if (info.order == info.order_with_drag) return fmt::format("{}", info.order);
    if (info.order_with_drag == 0) return fmt::format("{} (does not converge with drag)", info.order);
    return fmt::format("{} ({} with drag)", info.order, info.order_with_drag);
}

std::string limit_text(const MethodInfo& info) {
    if (info.adaptive) return "chooses its own steps";
    const double limit = linear_limit(info, ParameterValues(info.parameters));
    if (limit == 0) return "unstable at any dt";
    return std::isinf(limit) ? "stable at any dt" : fmt::format("ω dt < {:.5g}", limit);
}

std::string evaluations_text(const MethodInfo& info) {
    return fmt::format("{:g}", evaluations_per_step(info, ParameterValues(info.parameters)));
}

std::string method_in_full(const MethodInfo& info) {
    std::string text = fmt::format("### `{}`: {}\n\n{}\n\n", info.id, info.name, info.what);
    text += fmt::format("- order: {}\n- force evaluations per step: {}\n- stability limit on x'' = -ω²x: {}\n",
                        order_text(info), evaluations_text(info), limit_text(info));
    text += fmt::format("- symplectic: {}; reversible: {}\n", info.symplectic ? "yes" : "no",
                        info.reversible ? "yes" : "no");
    if (!info.conserves.empty()) text += fmt::format("- conservation: {}\n", info.conserves);
    text += fmt::format("- source: {}\n", info.source);
    if (!info.parameters.empty()) text += fmt::format("\n{}", parameter_table(info.parameters));
    return text + "\n";
}

}  // namespace

std::string models_table() {
    std::string table = "| model | description | parameters and their defaults |\n|---|---|---|\n";
    for (const Model& model : models()) {
        table +=
            fmt::format("| `{}` | {} | {} |\n", model.info.id, model.info.what, defaults_text(model.info.parameters));
    }
    return table;
}

std::string methods_table() {
    std::string table =
        "| method | name | order | evaluations per step | stability limit on x'' = -ω²x | conservation "
        "|\n|---|---|---|---|---|---|\n";
    for (const Method& method : methods()) {
        const MethodInfo& info = method.info;
        table += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", info.id, info.name, order_text(info),
                             evaluations_text(info), limit_text(info), info.conserves);
    }
    return table;
}

std::string models_in_full() {
    std::string text;
    for (const Model& model : models()) {
        text += fmt::format("### `{}`: {}\n\n{} The window opens it with `{}` and dt = {} s.\n\n{}\n", model.info.id,
                            model.info.name, model.info.what, model.opening.method, model.opening.dt,
                            parameter_table(model.info.parameters));
    }
    return text;
}

std::string methods_in_full() {
    std::string text;
    for (const Method& method : methods()) text += method_in_full(method.info);
    return text;
}

/// Without the blanks that folding leaves at the ends of lines.
std::string without_blanks_before_ends(std::string text) {
    for (std::size_t at; (at = text.find(" \n")) != std::string::npos;) text.erase(at, 1);
    return text;
}

std::string command_and_output(const std::string& command, const std::string& folder) {
    const TemporaryFolder scratch;
    const Outcome outcome = run(fmt::format("{{ {}; }} 2>/dev/null", command), scratch.path(), folder);
    if (outcome.code != 0) throw std::runtime_error("the documentation's command failed: " + command);
    return fmt::format("```console\n$ {}\n{}```\n", command, without_blanks_before_ends(outcome.output));
}

std::string help_of(const std::string& command, const std::string& folder) {
    const std::string text =
        command_and_output(fmt::format("steplab {}{}--help", command, command.empty() ? "" : " "), folder);
    const std::size_t catalogue = text.find("\nModels (--model)");
    return catalogue == std::string::npos ? text : text.substr(0, catalogue) + "```\n";
}

std::string picture_name(const HardCase& it) { return fmt::format("hard-{}.svg", it.id); }

std::string hard_case_in_full(const std::string& id) {
    const HardCase it = hard_case(id);
    return fmt::format("![{0}](images/{1})\n\n*{0}.*\n\n{2}", it.caption, picture_name(it), markdown(it.table()));
}

std::string section(const std::string& name, const std::string& folder) {
    if (name == "models") return models_table();
    if (name == "methods") return methods_table();
    if (name == "models in full") return models_in_full();
    if (name == "methods in full") return methods_in_full();
    if (name == "speed") return speed_tables(STEPLAB_RESULTS);
    if (name == "keys") return ui::key_table();
    if (name == "thesis table 1") return markdown(thesis_table_1());
    if (name == "thesis table 2") return markdown(thesis_table_2());
    if (name.starts_with("hard case ")) return hard_case_in_full(name.substr(10));
    if (name == "help") return help_of("", folder);
    if (name.starts_with("help ")) return help_of(name.substr(5), folder);
    if (name.starts_with("$ ")) return command_and_output(name.substr(2), folder);
    throw std::runtime_error("unknown made section of a page: " + name);
}

}  // namespace steplab::docs
