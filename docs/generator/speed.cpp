#include "speed.hpp"

#include "lab/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace steplab::docs {
namespace {

/// Who took how long for a step.
struct Time {
    std::string who;
    double step = 0, particle = 0;  ///< ns a step; ns a step and particle
};

struct Row {
    std::string id, method;
    double particles = 0;
    std::map<std::string, std::vector<Time>> times;  ///< by precision
};

struct Results {
    std::string name;
    std::string about;  ///< lines "key: value"
    std::vector<Row> rows;
};

bool is_lammps(const Time& time) { return time.who.starts_with("LAMMPS"); }

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

void add(Results& results, const std::vector<std::string>& cells) {
    const auto same = [&](const Row& row) { return row.id == cells[0] && row.method == cells[1]; };
    auto row = std::find_if(results.rows.begin(), results.rows.end(), same);
    if (row == results.rows.end()) row = results.rows.insert(row, {cells[0], cells[1], std::stod(cells[3]), {}});
    row->times[cells[2]].push_back({cells[4], std::stod(cells[5]), std::stod(cells[6])});
}

Results read(const std::filesystem::path& path) {
    Results results{path.stem().string(), {}, {}};
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("# ")) {
            results.about += fmt::format("- {}\n", line.substr(2));
        } else if (!line.starts_with("row,")) {
            const auto cells = cells_of(line);
            if (cells.size() < 7) throw std::runtime_error(path.string() + " has a line that is no result: " + line);
            add(results, cells);
        }
    }
    return results;
}

/// The fastest of those that are wanted.
template <class Wanted>
const Time* fastest(const Row& row, const std::string& precision, Wanted wanted) {
    const Time* best = nullptr;
    if (!row.times.contains(precision)) return nullptr;
    for (const Time& time : row.times.at(precision)) {
        if (wanted(time) && (!best || time.step < best->step)) best = &time;
    }
    return best;
}

const Time* own(const Row& row, const std::string& precision) {
    return fastest(row, precision, [](const Time& time) { return time.who == "steplab"; });
}

/// What the project wants to reach: times as fast as the best peer.
struct Goal {
    std::string_view row, method;  ///< how they begin
    double in_double, in_float;
};
constexpr Goal goals[] = {{"chain-10", "midpoint", 0, 0}, {"chain-100000", "rk4", 2.9, 3.2},
                          {"chain-100000", "", 2.0, 3.8}, {"chain-10", "", 2.0, 1.8},
                          {"mesh", "rk4", 2.1, 3.5},      {"mesh", "", 1.9, 3.2},
                          {"morse-28", "", 3, 5}};
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

std::string ratio_text(const Time* ours, const Time* theirs) {
    return ours && theirs ? fmt::format("{:.2f}", theirs->step / ours->step) : "-";
}

std::string peer_table(const Results& results) {
    Table table{{"row", "method", "precision", "steplab, ns", "best peer, ns", "who", "times as fast", "goal"}, {}};
    for (const Row& row : results.rows) {
        for (const std::string precision : {"double", "float"}) {
            const Time* theirs =
                fastest(row, precision, [](const Time& time) { return time.who != "steplab" && !is_lammps(time); });
            if (!theirs) continue;
            const Time* ours = own(row, precision);
            table.rows.push_back({row.id, fmt::format("`{}`", row.method), precision, time_text(row, ours),
                                  time_text(row, theirs), theirs->who, ratio_text(ours, theirs),
                                  goal_text(goals, row, precision == "float")});
        }
    }
    return markdown(table);
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

}  // namespace

std::string speed_tables(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::string text;
    for (const auto& path : files) {
        const Results results = read(path);
        text += fmt::format("{}### {}\n\n{}\n{}{}", text.empty() ? "" : "\n", results.name, results.about,
                            peer_table(results), lammps_table(results));
    }
    return text;
}

}  // namespace steplab::docs
