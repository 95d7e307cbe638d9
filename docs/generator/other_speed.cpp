#include "other_speed.hpp"

#include "lab/report/table.hpp"

#include <fmt/format.h>

#include <regex>
#include <string_view>
#include <utility>

namespace steplab::docs {
namespace {

/// The speed-up over the fastest library with the plain force that the project aims at, for a scene and an error: what
/// prototypes reached. Where these were slower, there is no goal.
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

double goal_of(const Row& row) {
    for (const ErrorGoal& goal : error_goals) {
        if (row.id == goal.row && row.method == goal.error) return goal.times;
    }
    return 0;
}

/// "chain" of "error-chain".
std::string after_dash(const std::string& id) { return id.substr(id.find('-') + 1); }

/// "odeint adams 8, 500 steps, gather" of "odeint adams 8 5e+02 gather": a setting is a number of steps, a tolerance or
/// "dt 0.5".
std::string method_text(const std::string& who) {
    static const std::regex setting(R"((.*?) (dt )?([0-9.]+(?:e[+-]\d+)?)( plain| gather)?)");
    std::smatch match;
    if (!std::regex_match(who, match, setting)) return who;
    const double value = std::stod(match[3]);
    const bool is_dt = match[2].matched;
    const std::string text = is_dt        ? fmt::format("dt {}", match[3].str())
                             : value >= 1 ? fmt::format("{:.0f} steps", value)
                                          : fmt::format("tolerance {}", match[3].str());
    const std::string force = match[4].matched ? fmt::format(",{}", match[4].str()) : "";
    return fmt::format("{}, {}{}", match[1].str(), text, force);
}

/// A line for each precision of the rows whose names begin with `id`: the cells that `cells` makes of the row, the
/// precision and steplab's time.
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
        const double rate = 1e9 / ours.step, goal = row.particles >= 1e6 ? 3 : row.particles <= 1e4 ? 30 : 0;
        const std::string beside =
            bare ? fmt::format("; {:.1f} times as long as a bare `GL_POINTS` draw", ours.step / bare->step) : "";
        return std::vector<std::string>{
            fmt::format("rendering, {:.0f} particles", row.particles), fmt::format("{:.1f} frames/s{}", rate, beside),
            goal > 0 ? goal_text(fmt::format(">= {:.0f} frames/s", goal), rate >= goal) : ""};
    });
}

void add_watching(Table& table, const Results& results) {
    add_lines(table, results, "watching-", [](const Row& row, const std::string& precision, const Time& alone) {
        const Time* watched = own_with(row, precision);
        const double part = watched ? 1 - alone.step / watched->step : 0;
        return std::vector<std::string>{
            fmt::format("share of a run's time spent on views for the window, {:.0f} particles, {}", row.particles,
                        precision),
            watched ? fmt::format("{:.1f} %", 100 * part) : "-", goal_text("< 5 %", part < 0.05)};
    });
}

void add_files(Table& table, const Results& results) {
    add_lines(table, results, "writing-", [](const Row& row, const std::string& precision, const Time& ours) {
        const std::string format = after_dash(row.id);
        const double rate = 1e3 / ours.particle, goal = 200;
        return std::vector<std::string>{
            fmt::format("writing `{}`, {}, one core", format, precision), fmt::format("{:.0f} MB/s", rate),
            format == "trajectory" ? "" : goal_text(fmt::format(">= {:.0f} MB/s", goal), rate >= goal)};
    });
}

void add_process(Table& table, const Results& results, std::string_view id, std::string what, double goal) {
    add_lines(table, results, id, [&](const Row& row, const std::string& precision, const Time& ours) {
        const Time* nothing = fastest(row, precision, [](const Time& time) { return time.who == "nothing"; });
        const double milliseconds = 1e-6 * ours.step;
        const std::string beside = nothing ? fmt::format("; `true` takes {:.1f} ms", 1e-6 * nothing->step) : "";
        return std::vector<std::string>{what, fmt::format("{:.1f} ms{}", milliseconds, beside),
                                        goal_text(fmt::format("<= {:.0f} ms", goal), milliseconds <= goal)};
    });
}

}  // namespace

std::string error_section(const Results& results) {
    Table table{{"scene", "error", "steplab [µs]", "method", "fastest library [µs]", "library", "speed-up",
                 "fastest with *plain* force [µs]", "speed-up over *plain*", "goal over *plain*"},
                {}};
    const auto plain = [](const Time& time) { return is_peer(time) && time.who.ends_with(" plain"); };
    const auto microseconds = [](const Time* time) { return time ? fmt::format("{:.0f}", 1e-3 * time->step) : "-"; };
    for (const Row* row : rows_of(results, "error-")) {
        const Time* ours = own_with(*row, "double");
        const Time *theirs = fastest(*row, "double", is_peer), *in_plain = fastest(*row, "double", plain);
        if (!ours) continue;
        const double goal = in_plain ? goal_of(*row) : 0;
        table.rows.push_back({fmt::format("`{}`", after_dash(row->id)), row->method, microseconds(ours),
                              method_text(ours->who.substr(std::string_view("steplab ").size())), microseconds(theirs),
                              theirs ? method_text(theirs->who) : "none reaches the error", ratio_text(ours, theirs),
                              microseconds(in_plain), ratio_text(ours, in_plain), goal_text(goal, ours, in_plain)});
    }
    return table.rows.empty() ? "" : fmt::format("\nTime to a given error, in double:\n\n{}", markdown(table));
}

std::string others_section(const Results& results) {
    Table table{{"rendering, files and processes", "measured", "goal"}, {}};
    add_pictures(table, results);
    add_watching(table, results);
    add_files(table, results);
    add_process(table, results, "process-run", "`steplab run`, 1000 steps of 10 particles", 15);
    add_process(table, results, "process-snapshot", "`steplab snapshot`", 300);
    return table.rows.empty() ? "" : fmt::format("\n{}", markdown(table));
}

}  // namespace steplab::docs
