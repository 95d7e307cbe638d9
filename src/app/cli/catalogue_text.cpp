#include "app/cli/catalogue_text.hpp"

#include "app/cli/text_table.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace steplab {

namespace {

std::string default_text(const ParameterInfo& info) {
    const std::string value = format_value(info, info.default_value);
    return info.unit.empty() ? value : fmt::format("{} {}", value, info.unit);
}

std::string parameter_rows(std::span<const ParameterInfo> parameters) {
    if (parameters.empty()) return "";
    std::vector<Row> rows;
    for (const ParameterInfo& info : parameters) {
        rows.push_back(
            {std::string(info.name), "default " + default_text(info), range_text(info), std::string(info.what)});
    }
    return aligned(rows, 4);
}

/// Every entry with its parameters; all begin their descriptions at the same column.
template <class Entry>
std::string entries_with_parameters(std::span<const Entry> entries) {
    std::size_t width = 0;
    for (const Entry& entry : entries) width = std::max(width, entry.info.id.size());
    std::string text;
    for (const Entry& entry : entries) {
        const std::string id = fmt::format("{:<{}}", entry.info.id, width + 2);
        text += id + wrapped(fmt::format("{}: {}", entry.info.name, entry.info.what), id.size()) + '\n' +
                parameter_rows(entry.info.parameters);
    }
    return text;
}

std::string settings(std::span<const ParameterInfo> parameters) {
    std::string text;
    for (const ParameterInfo& info : parameters) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", info.name, format_value(info, info.default_value));
    }
    return text;
}

std::string limit_text(const MethodInfo& info) {
    if (info.linear_limit == 0) return "unstable";
    const double limit = linear_limit(info, ParameterValues(info.parameters));
    return limit == infinity ? "any dt" : fmt::format("< {:.4g}", limit);
}

std::string properties(const MethodInfo& info) {
    std::string text;
    const auto add = [&text](bool has, std::string_view word) {
        if (has) text += (text.empty() ? "" : ", ") + std::string(word);
    };
    add(info.symplectic, "symplectic");
    add(info.reversible, "reversible");
    add(info.adaptive, "adaptive");
    add(info.implicit, "implicit");
    add(info.curiosity, "curiosity");
    return text.empty() ? "-" : text;
}

}  // namespace

std::string catalogue_hint() {
    return "Models, methods and their parameters: steplab list, steplab list models, steplab list methods";
}

std::string models_with_parameters() {
    return "Models (--model) and their parameters (--set name=value)\n\n" + entries_with_parameters(models());
}

std::string methods_with_parameters() {
    return "Methods (--method) and their parameters (--set name=value)\n\n" + entries_with_parameters(methods());
}

std::string models_table() {
    std::vector<Row> rows{{"MODEL", "DESCRIPTION AND PARAMETERS"}};
    for (const Model& model : models()) {
        rows.push_back({std::string(model.info.id), fmt::format("{}: {}", model.info.name, model.info.what)});
        rows.push_back({"", settings(model.info.parameters)});
    }
    return aligned(rows, 0);
}

std::string methods_table() {
    std::vector<Row> rows{{"METHOD", "NAME", "ORDER", "EVALUATIONS", "STABLE ω dt", "PROPERTIES"}};
    for (const Method& method : methods()) {
        const MethodInfo& info = method.info;
        std::string evaluations = fmt::format("{:g}", evaluations_per_step(info, ParameterValues(info.parameters)));
        if (const ParameterValues values(info.parameters); values.contains("substeps"))
            evaluations += fmt::format(" (substeps={:g})", values["substeps"]);
        rows.push_back({std::string(info.id), std::string(info.name), std::to_string(info.order), evaluations,
                        limit_text(info), properties(info)});
    }
    return aligned(rows, 0);
}

}  // namespace steplab
