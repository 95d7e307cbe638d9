#pragma once

#include "core/expression_program.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// A program as atom-style variables of LAMMPS, one for each operation.
struct LammpsFormula {
    std::string lines;                 ///< "variable NAME_0 atom x*x", ...
    std::vector<std::string> results;  ///< what stands for each in a formula: "v_NAME_7", "x", "(2.5)"
};

/// `variables`: what stands for those of the program in a formula.
LammpsFormula formula_of(const ExpressionProgram& program, std::span<const std::string> variables,
                         const std::string& name);
/// True if the program reads a variable.
bool reads(const ExpressionProgram& program, std::size_t variable);

}  // namespace steplab
