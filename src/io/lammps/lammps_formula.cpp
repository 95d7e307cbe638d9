#include "io/lammps/lammps_formula.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

namespace {

/// Operands are names, numbers or in brackets.
std::string formula(ExpressionProgram::Operation operation, const std::string& a, const std::string& b,
                    const std::string& c, const std::string& d) {
    using Operation = ExpressionProgram::Operation;
    switch (operation) {
        case Operation::add:
            return fmt::format("{}+{}", a, b);
        case Operation::subtract:
            return fmt::format("{}-{}", a, b);
        case Operation::multiply:
            return fmt::format("{}*{}", a, b);
        case Operation::invert:
            return fmt::format("{}/{}", b, a);
        case Operation::negate:
            return fmt::format("{}-{}", b, a);
        case Operation::exp:
            return fmt::format("exp({})", a);
        case Operation::log:
            return fmt::format("ln({})", a);
        case Operation::sqrt:
            return fmt::format("sqrt({})", a);
        case Operation::sin:
            return fmt::format("sin({})", a);
        case Operation::cos:
            return fmt::format("cos({})", a);
        case Operation::tan:
            return fmt::format("tan({})", a);
        case Operation::tanh:
            return fmt::format("1-2/(exp(2*{})+1)", a);
        case Operation::power:
            return fmt::format("{}^{}", a, b);
        case Operation::choose:
            break;
    }
    return fmt::format("({0}<{1})*{2}+({0}>={1})*{3}", a, b, c, d);
}

}  // namespace

/// Slots are used again: each operation gets a name of its own.
LammpsFormula formula_of(const ExpressionProgram& program, std::span<const std::string> variables,
                         const std::string& name) {
    LammpsFormula made;
    std::vector<std::string> texts(variables.begin(), variables.end());
    for (const double constant : program.constants) texts.push_back(fmt::format("({})", constant));
    texts.resize(std::max(texts.size(), program.slots));
    for (std::size_t i = 0; i < program.steps.size(); ++i) {
        const auto& [operation, target, operands] = program.steps[i];
        const auto& [a, b, c, d] = operands;
        made.lines += fmt::format("variable {}_{} atom {}\n", name, i,
                                  formula(operation, texts[a], texts[b], texts[c], texts[d]));
        texts[target] = fmt::format("v_{}_{}", name, i);
    }
    for (const std::uint32_t slot : program.results) made.results.push_back(texts[slot]);
    return made;
}

bool reads(const ExpressionProgram& program, std::size_t variable) {
    return std::any_of(program.steps.begin(), program.steps.end(), [&](const ExpressionProgram::Step& step) {
        return std::find(step.operands.begin(), step.operands.end(), variable) != step.operands.end();
    });
}

}  // namespace steplab
