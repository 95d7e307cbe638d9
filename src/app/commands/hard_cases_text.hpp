#pragma once

#include "lab/hard_cases/hard_case.hpp"

#include <span>
#include <string>

namespace steplab {

/// A row for each case: id and title.
std::string hard_cases_list(std::span<const HardCase> cases);
/// A JSON list of objects: id, title, shows.
std::string hard_cases_json(std::span<const HardCase> cases);

/// Title, what the case shows, and its table, at most 100 columns wide. `table`: that of the case.
std::string hard_case_text(const HardCase& hard_case, const Table& table);
/// One JSON object: id, title, shows, `columns`, the heads of the table, and `rows`, a list of texts for each method.
std::string hard_case_json(const HardCase& hard_case, const Table& table);

}  // namespace steplab
