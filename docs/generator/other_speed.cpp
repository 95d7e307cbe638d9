#include "other_speed.hpp"

#include "lab/report/table.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace steplab::docs {
namespace {

/// How many times as fast as the best library with the plain force the probes of steplab's laboratory were for a scene
/// and an error; where they were slower, there is no goal.
struct ErrorGoal {
    std::string_view row, error;
    double times;
};
constexpr ErrorGoal error_goals[] = {
    {"error-chain", "1e-02", 2.9},  {"error-chain", "1e-04", 2.1}, {"error-chain", "1e-06", 2.7},
    {"error-chain", "1e-08", 4.2},  {"error-chain", "1e-10", 4.4}, {"error-chain", "1e-12", 5.0},
    {"error-morse", "1e-06", 3.9},  {"error-morse", "1e-08", 6.3}, {"error-morse", "1e-12", 11.3},
    {"error-morse", "1e-14", 11.4}, {"error-mesh", "1e-02", 2.9},  {"error-mesh", "1e-04", 2.9},
    {"error-mesh", "1e-06", 4.0},   {"error-mesh", "1e-08", 5.4},  {"error-mesh", "1e-10", 6.2},
    {"error-mesh", "1e-12", 8.0}};

std::string goal_of(const Row& row) {
    for (const ErrorGoal& goal : error_goals) {
        if (row.id == goal.row && row.method == goal.error) return fmt::format("{:.1f}", goal.times);
    }
    return "";
}

/// "chain" of "error-chain".
std::string after_dash(const std::string& id) { return id.substr(id.find('-') + 1); }

/// A line for each of these rows that steplab has a time in: what `cells` makes of the row and its precision.
template <class Cells>
void add_lines(Table& table, const Results& results, std::string_view id, Cells cells) {
    for (const Row* row : rows_of(results, id)) {
        for (const std::string precision : {"double", "float"}) {
            if (const Time* ours = own(*row, precision)) table.rows.push_back(cells(*row, precision, *ours));
        }
    }
}

void add_pictures(Table& table, const Results& results) {
    add_lines(table, results, "drawing-", [](const Row& row, const std::string& precision, const Time& ours) {
        const Time* bare = fastest(row, precision, [](const Time& time) { return time.who == "bare points"; });
        const std::string goal = row.particles >= 1e6 ? "3 a second" : row.particles <= 1e4 ? "30 a second" : "";
        const std::string beside =
            bare ? fmt::format("; {:.1f} times `GL_POINTS` of the same arrays", ours.step / bare->step) : "";
        return std::vector<std::string>{fmt::format("pictures of {:.0f} particles", row.particles),
                                        fmt::format("{:.1f} a second{}", 1e9 / ours.step, beside), goal};
    });
}

void add_watching(Table& table, const Results& results) {
    add_lines(table, results, "watching-", [](const Row& row, const std::string& precision, const Time& alone) {
        const Time* watched = own_with(row, precision);
        const double part = watched ? 1 - alone.step / watched->step : 0;
        return std::vector<std::string>{
            fmt::format("of the stepping of {:.0f} particles, {}, handed over to a picture", row.particles, precision),
            watched ? fmt::format("{:.1f} %", 100 * part) : "-", "below 5 %"};
    });
}

void add_files(Table& table, const Results& results) {
    add_lines(table, results, "writing-", [](const Row& row, const std::string& precision, const Time& ours) {
        const std::string format = after_dash(row.id);
        return std::vector<std::string>{fmt::format("{} in {}, of a core", format, precision),
                                        fmt::format("{:.0f} MB/s", 1e3 / ours.particle),
                                        format == "trajectory" ? "" : "200 MB/s"};
    });
}

void add_process(Table& table, const Results& results, std::string_view id, std::string what, std::string goal) {
    add_lines(table, results, id, [&](const Row& row, const std::string& precision, const Time& ours) {
        const Time* nothing = fastest(row, precision, [](const Time& time) { return time.who == "nothing"; });
        const std::string beside =
            nothing ? fmt::format("; a process that does nothing {:.1f} ms", 1e-6 * nothing->step) : "";
        return std::vector<std::string>{what, fmt::format("{:.1f} ms{}", 1e-6 * ours.step, beside), goal};
    });
}

}  // namespace

std::string error_section(const Results& results) {
    Table table{{"scene", "error", "steplab, µs", "by", "best library, µs", "by", "times as fast", "plain, µs",
                 "times as fast", "goal"},
                {}};
    const auto plain = [](const Time& time) { return is_peer(time) && time.who.ends_with(" plain"); };
    const auto microseconds = [](const Time* time) { return time ? fmt::format("{:.0f}", 1e-3 * time->step) : "-"; };
    for (const Row* row : rows_of(results, "error-")) {
        const Time* ours = own_with(*row, "double");
        const Time *theirs = fastest(*row, "double", is_peer), *in_plain = fastest(*row, "double", plain);
        if (!ours) continue;
        table.rows.push_back({fmt::format("`{}`", after_dash(row->id)), row->method, microseconds(ours),
                              ours->who.substr(std::string_view("steplab ").size()), microseconds(theirs),
                              theirs ? theirs->who : "none reaches it", ratio_text(ours, theirs),
                              microseconds(in_plain), ratio_text(ours, in_plain), goal_of(*row)});
    }
    return table.rows.empty() ? "" : fmt::format("\nWhole runs to an error, in double:\n\n{}", markdown(table));
}

std::string others_section(const Results& results) {
    Table table{{"drawing, files and processes", "measured", "goal"}, {}};
    add_pictures(table, results);
    add_watching(table, results);
    add_files(table, results);
    add_process(table, results, "process-run", "`steplab run`, 1000 steps of ten particles", "15 ms");
    add_process(table, results, "process-snapshot", "`steplab snapshot`", "300 ms");
    return table.rows.empty() ? "" : fmt::format("\n{}", markdown(table));
}

}  // namespace steplab::docs
