#include "io/csv_line.hpp"

#include "core/error.hpp"
#include "io/number_read.hpp"

#include <algorithm>

namespace steplab {

std::optional<CsvBegin> csv_begin(std::string_view line) {
    const std::size_t step_end = std::min(line.find(','), line.size());
    const std::size_t time_end = std::min(line.find(',', step_end + 1), line.size());
    if (time_end == line.size()) return std::nullopt;
    const auto step = number_in<std::uint64_t>(line.substr(0, step_end));
    const auto time = number_in<double>(line.substr(step_end + 1, time_end - step_end - 1));
    if (!step || !time) return std::nullopt;
    return csv_begin_after({line.substr(0, time_end + 1), {*step, *time}}, line);
}

std::optional<CsvBegin> csv_begin_after(const CsvBegin& before, std::string_view line) {
    if (before.moment_text.empty() || !line.starts_with(before.moment_text)) return std::nullopt;
    const std::size_t begin = before.moment_text.size(), end = line.find(',', begin);
    if (end == std::string_view::npos) return std::nullopt;
    const auto particle = number_in<std::uint64_t>(line.substr(begin, end - begin));
    if (!particle) return std::nullopt;
    return CsvBegin{line.substr(0, begin), before.moment, *particle};
}

Columns columns_of_csv(std::string_view head) {
    constexpr std::string_view begin = "step,time,particle,";
    if (!head.starts_with(begin)) throw UsageError("it has no columns of numbers behind step,time,particle");
    return parse_columns(head.substr(begin.size()));
}

}  // namespace steplab
