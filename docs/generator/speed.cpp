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

/// The speed-up over the fastest peer that the project aims at; 0: none was set.
struct Goal {
    std::string_view row, method;  ///< how their names begin
    double in_double, in_float;
};
constexpr Goal goals[] = {{"chain-10", "midpoint", 0, 0}, {"chain-100000", "rk4", 2.9, 3.2},
                          {"chain-100000", "", 2.0, 3.8}, {"chain-10", "", 2.0, 1.8},
                          {"mesh", "rk4", 2.1, 3.5},      {"mesh", "", 1.9, 3.2},
                          {"morse-28", "", 3, 5}};
constexpr Goal plain_goals[] = {{"morse-28", "", 5.8, 8}};
constexpr Goal lammps_goals[] = {{"mesh", "", 4.5, 9}, {"morse-bulk", "", 3.0, 4.5}};

template <std::size_t count>
double goal_of(const Goal (&all)[count], const Row& row, bool in_float) {
    for (const Goal& goal : all) {
        if (!row.id.starts_with(goal.row) || !row.method.starts_with(goal.method)) continue;
        return in_float ? goal.in_float : goal.in_double;
    }
    return 0;
}

/// Whether the times of the row are per step; those of larger scenes are per particle and step.
bool is_small(const Row& row) { return row.particles < 1000; }
bool is_large(const Row& row) { return !is_small(row); }

std::string time_text(const Row& row, const Time* time) {
    if (!time) return "-";
    return is_small(row) ? fmt::format("{:.1f}", time->step) : fmt::format("{:.2f}", time->particle);
}

/// The table below its title; empty if it has no rows.
std::string titled(std::string_view title, const Table& table) {
    return table.rows.empty() ? "" : fmt::format("\n{}\n\n{}", title, markdown(table));
}

/// A line for each precision of the rows whose names begin with `id` and that are `wanted`, against the fastest `peer`.
template <class Wanted, class Peer, std::size_t count>
Table comparison(const Results& results, std::string_view id, Wanted wanted, Peer peer, const Goal (&all)[count]) {
    Table table{{"row", "method", "precision", "steplab [ns]", "fastest peer [ns]", "peer", "speed-up", "goal"}, {}};
    for (const Row* row : rows_of(results, id)) {
        for (const std::string precision : {"double", "float"}) {
            const Time *ours = own(*row, precision), *theirs = fastest(*row, precision, peer);
            if (!wanted(*row) || !ours || !theirs) continue;
            table.rows.push_back({row->id, fmt::format("`{}`", row->method), precision, time_text(*row, ours),
                                  time_text(*row, theirs), theirs->who, ratio_text(ours, theirs),
                                  goal_text(goal_of(all, *row, precision == "float"), ours, theirs)});
        }
    }
    return table;
}

std::string peer_tables(const Results& results) {
    const auto library = [](const Time& time) { return is_peer(time) && !is_lammps(time); };
    return titled("Small scenes, time per step:", comparison(results, "", is_small, library, goals)) +
           titled("Large scenes, time per particle and step:", comparison(results, "", is_large, library, goals));
}

/// Against forces between all pairs of a few particles that compilers do not vectorise.
std::string plain_table(const Results& results) {
    const auto plain = [](const Time& time) { return time.who.ends_with(" plain"); };
    return titled("`morse` of 28 particles against peers with the *plain* force, time per step:",
                  comparison(results, "morse-28", is_small, plain, plain_goals));
}

std::string lammps_table(const Results& results) {
    Table table{{"row", "peer", "peer [ns]", "steplab, double [ns]", "speed-up", "goal", "steplab, float [ns]",
                 "speed-up", "goal"},
                {}};
    for (const Row& row : results.rows) {
        const Time* theirs = fastest(row, "double", is_lammps);
        if (!theirs) continue;
        std::vector<std::string> cells{row.id, theirs->who, time_text(row, theirs)};
        for (const std::string precision : {"double", "float"}) {
            const Time* ours = own(row, precision);
            const double goal = ours ? goal_of(lammps_goals, row, precision == "float") : 0;
            for (auto& cell : {time_text(row, ours), ratio_text(ours, theirs), goal_text(goal, ours, theirs)})
                cells.push_back(cell);
        }
        table.rows.push_back(cells);
    }
    return titled("Against LAMMPS, which computes in double, time per particle and step:", table);
}

std::string ensemble_table(const Results& results) {
    Table table{{"method", "precision", "single run [ns]", "in an ensemble [ns]", "speed-up", "goal"}, {}};
    for (const Row* row : rows_of(results, "chain-10-ensemble")) {
        for (const std::string precision : {"double", "float"}) {
            const Time *one = own(*row, precision), *many = own_with(*row, precision);
            const double goal = !one || !many || row->method != "euler" ? 0 : precision == "double" ? 2.4 : 6.0;
            table.rows.push_back({fmt::format("`{}`", row->method), precision, time_text(*row, one),
                                  time_text(*row, many), ratio_text(many, one), goal_text(goal, many, one)});
        }
    }
    return titled("Ensemble of 64 runs of a `chain` of 10 that differ in k, time per run and step:", table);
}

/// A scene of increasing size: time per particle and step on one thread and on the largest number of threads measured.
std::string growing_table(const Results& results, std::string_view title, std::string_view id) {
    Table table{{"particles", "double [ns]", "with threads [ns]", "speed-up", "float [ns]", "with threads [ns]",
                 "speed-up", "goal"},
                {}};
    for (const Row* row : rows_of(results, id)) {
        std::vector<std::string> cells{fmt::format("{:.0f}", row->particles)};
        constexpr double goal = 1.8;  // on two threads
        bool has_goal = false, reached = true;
        for (const std::string precision : {"double", "float"}) {
            const Time *one = own(*row, precision), *threads = own_with(*row, precision);
            cells.push_back(one ? fmt::format("{:.2f}", one->particle) : "-");
            cells.push_back(threads ? fmt::format("{:.2f} ({})", threads->particle, threads->who.substr(8)) : "");
            cells.push_back(threads ? ratio_text(threads, one) : "");
            if (!one || !threads || threads->who != "steplab 2 threads") continue;
            has_goal = true;
            reached = reached && one->step >= goal * threads->step;
        }
        cells.push_back(has_goal ? goal_text(fmt::format("{:.1f}", goal), reached) : "");
        table.rows.push_back(cells);
    }
    return titled(title, table);
}

std::string machine_table(const Results& results) {
    Table table{{"limit of one core", "double", "float"}, {}};
    for (const Row* row : rows_of(results, "machine-springs")) {
        std::vector<std::string> cells{"square root and division, per number"};
        for (const std::string precision : {"double", "float"})
            cells.push_back(fmt::format("{:.2f} ns", machine_time(*row, precision)));
        table.rows.push_back(cells);
    }
    for (const Bandwidth& each : bandwidths(results)) {
        const std::string speed = fmt::format("{:.0f} GB/s", each.bytes_per_second / 1e9);
        table.rows.push_back({fmt::format("bandwidth of y += c x over {}", size_text(each.size)), speed, speed});
    }
    return titled("Limits of the machine:", table);
}

std::string picture(const Results& results, std::string_view of, std::string_view caption) {
    return fmt::format("\n![{}](images/{})\n", caption, speed_picture_name(results, of));
}

std::string growing_section(const Results& results) {
    if (rows_of(results, "growing-chain").empty()) return "";
    return growing_table(results,
                         "Scaling of a `chain`, `velocity-verlet`, time per particle and step:", "growing-chain") +
           growing_table(results, "Scaling of a `mesh`:", "growing-mesh") +
           growing_table(results, "Scaling of a `crystal`:", "morse-bulk") +
           picture(results, "growing", "Time per particle and step against the number of particles") +
           machine_table(results) +
           picture(results, "roofline", "Roofline: springs per second against springs per byte read or written");
}

}  // namespace

std::string speed_tables(const std::filesystem::path& folder) {
    std::string text;
    for (const Results& results : read_results(folder)) {
        text += fmt::format("{}### {}\n\n{}", text.empty() ? "" : "\n", results.name, results.about);
        for (const auto section :
             {peer_tables, plain_table, lammps_table, ensemble_table, growing_section, error_section, others_section})
            text += section(results);
    }
    return text;
}

}  // namespace steplab::docs
