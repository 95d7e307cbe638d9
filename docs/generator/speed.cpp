#include "speed.hpp"

#include "lab/report/table.hpp"
#include "other_speed.hpp"
#include "results.hpp"
#include "speed_figures.hpp"

#include <fmt/format.h>

#include <string_view>

namespace steplab::docs {
namespace {

bool is_lammps(const Time& time) { return time.who.starts_with("LAMMPS"); }

/// What the project wants to reach: times as fast as the best peer.
struct Goal {
    std::string_view row, method;  ///< how they begin
    double in_double, in_float;
};
constexpr Goal goals[] = {{"chain-10", "midpoint", 0, 0}, {"chain-100000", "rk4", 2.9, 3.2},
                          {"chain-100000", "", 2.0, 3.8}, {"chain-10", "", 2.0, 1.8},
                          {"mesh", "rk4", 2.1, 3.5},      {"mesh", "", 1.9, 3.2},
                          {"morse-28", "", 3, 5}};
constexpr Goal plain_goals[] = {{"morse-28", "", 5.8, 8}};
constexpr Goal lammps_goals[] = {{"mesh", "", 4.5, 9}, {"morse-bulk", "", 3.0, 4.5}};

template <std::size_t count>
std::string goal_text(const Goal (&all)[count], const Row& row, bool in_float) {
    for (const Goal& goal : all) {
        if (!row.id.starts_with(goal.row) || !row.method.starts_with(goal.method)) continue;
        const double value = in_float ? goal.in_float : goal.in_double;
        return value > 0 ? fmt::format("{:.1f}", value) : "";
    }
    return "";
}

std::string time_text(const Row& row, const Time* time) {
    if (!time) return "-";
    return row.particles < 1000 ? fmt::format("{:.1f}", time->step) : fmt::format("{:.2f}", time->particle);
}

/// A line for each precision of the rows whose names begin with `id`, beside the fastest of `who`.
template <class Who, std::size_t count>
Table comparison(const Results& results, std::string_view id, Who who, const Goal (&all)[count]) {
    Table table{{"row", "method", "precision", "steplab, ns", "best peer, ns", "who", "times as fast", "goal"}, {}};
    for (const Row* row : rows_of(results, id)) {
        for (const std::string precision : {"double", "float"}) {
            const Time *ours = own(*row, precision), *theirs = fastest(*row, precision, who);
            if (!ours || !theirs) continue;
            table.rows.push_back({row->id, fmt::format("`{}`", row->method), precision, time_text(*row, ours),
                                  time_text(*row, theirs), theirs->who, ratio_text(ours, theirs),
                                  goal_text(all, *row, precision == "float")});
        }
    }
    return table;
}

std::string peer_table(const Results& results) {
    const auto library = [](const Time& time) { return is_peer(time) && !is_lammps(time); };
    return markdown(comparison(results, "", library, goals));
}

/// Beside forces that compilers do not vectorise, of all pairs of a few particles.
std::string plain_table(const Results& results) {
    const auto plain = [](const Time& time) { return time.who.ends_with(" plain"); };
    const Table table = comparison(results, "morse-28", plain, plain_goals);
    return table.rows.empty() ? "" : fmt::format("\nMorse beside the plain force alone:\n\n{}", markdown(table));
}

std::string lammps_table(const Results& results) {
    Table table{{"row", "LAMMPS, ns", "who", "steplab in double, ns", "times as fast", "goal", "in float, ns",
                 "times as fast", "goal"},
                {}};
    for (const Row& row : results.rows) {
        const Time* theirs = fastest(row, "double", is_lammps);
        if (!theirs) continue;
        const Time *in_double = own(row, "double"), *in_float = own(row, "float");
        table.rows.push_back({row.id, time_text(row, theirs), theirs->who, time_text(row, in_double),
                              ratio_text(in_double, theirs), goal_text(lammps_goals, row, false),
                              time_text(row, in_float), ratio_text(in_float, theirs),
                              goal_text(lammps_goals, row, true)});
    }
    return table.rows.empty() ? "" : "\nBeside LAMMPS, which computes in double:\n\n" + markdown(table);
}

/// Many runs at once beside one: ns a run and step.
std::string ensemble_table(const Results& results) {
    Table table{{"method", "precision", "one run, ns", "in an ensemble, ns", "times as fast", "goal"}, {}};
    for (const Row* row : rows_of(results, "chain-10-ensemble")) {
        for (const std::string precision : {"double", "float"}) {
            const Time *one = own(*row, precision), *many = own_with(*row, precision);
            const std::string goal = row->method != "euler" ? "" : precision == "double" ? "2.4" : "6.0";
            table.rows.push_back({fmt::format("`{}`", row->method), precision, time_text(*row, one),
                                  time_text(*row, many), ratio_text(many, one), goal});
        }
    }
    return table.rows.empty() ? ""
                              : "\nEnsembles of 64 runs of a `chain` of 10 that differ in k:\n\n" + markdown(table);
}

/// A scene as it grows: ns a step and particle, by one thread and by the most that were tried.
std::string growing_table(const Results& results, std::string_view id) {
    Table table{{"particles", "double, ns", "with threads", "times as fast", "float, ns", "with threads",
                 "times as fast", "goal"},
                {}};
    for (const Row* row : rows_of(results, id)) {
        std::vector<std::string> cells{fmt::format("{:.0f}", row->particles)};
        std::string goal;
        for (const std::string precision : {"double", "float"}) {
            const Time *one = own(*row, precision), *threads = own_with(*row, precision);
            cells.push_back(one ? fmt::format("{:.2f}", one->particle) : "-");
            cells.push_back(threads ? fmt::format("{:.2f} ({})", threads->particle, threads->who.substr(8)) : "");
            cells.push_back(threads ? ratio_text(threads, one) : "");
            if (threads && threads->who == "steplab 2 threads") goal = "1.8";
        }
        cells.push_back(goal);
        table.rows.push_back(cells);
    }
    return markdown(table);
}

/// What the machine can do at most.
std::string machine_table(const Results& results) {
    Table table{{"one core at most", "double", "float"}, {}};
    for (const Row* row : rows_of(results, "machine-springs")) {
        std::vector<std::string> cells{"square root and division"};
        for (const std::string precision : {"double", "float"})
            cells.push_back(fmt::format("{:.2f} ns", machine_time(*row, precision)));
        table.rows.push_back(cells);
    }
    for (const Bandwidth& each : bandwidths(results)) {
        const std::string speed = fmt::format("{:.0f} GB/s", each.bytes_a_second / 1e9);
        table.rows.push_back({fmt::format("two reads and a write over {}", size_text(each.size)), speed, speed});
    }
    return markdown(table);
}

std::string picture(const Results& results, std::string_view of, std::string_view caption) {
    return fmt::format("![{}](images/{})\n", caption, speed_picture_name(results, of));
}

std::string growing_section(const Results& results) {
    if (rows_of(results, "growing-chain").empty()) return "";
    return fmt::format(
        "\n{}\nA `chain` that grows, `velocity-verlet`, ns a step and particle:\n\n{}\n"
        "A `mesh` that grows:\n\n{}{}\nWhat one core can do at most, and how near steplab comes to it:\n\n{}\n{}",
        picture(results, "growing", "ns a step and particle over the number of particles"),
        growing_table(results, "growing-chain"), growing_table(results, "growing-mesh"),
        rows_of(results, "morse-bulk").empty() ? ""
                                               : "\nA `crystal` that grows:\n\n" + growing_table(results, "morse-bulk"),
        machine_table(results),
        picture(results, "roofline", "springs a second over springs a byte, below the roofs of the machine"));
}

}  // namespace

std::string speed_tables(const std::filesystem::path& folder) {
    std::string text;
    for (const Results& results : read_results(folder)) {
        text += fmt::format("{}### {}\n\n{}\n{}{}{}{}{}{}{}", text.empty() ? "" : "\n", results.name, results.about,
                            peer_table(results), plain_table(results), lammps_table(results), ensemble_table(results),
                            growing_section(results), error_section(results), others_section(results));
    }
    return text;
}

}  // namespace steplab::docs
