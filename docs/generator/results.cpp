#include "results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace steplab::docs {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

void add(Results& results, const std::vector<std::string>& cells) {
    const auto same = [&](const Row& row) {
        return row.id == cells[0] && row.method == cells[1] && row.particles == std::stod(cells[3]);
    };
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
            if (cells.size() < 7)
                throw std::runtime_error(path.string() + " has a line with fewer than 7 cells: " + line);
            add(results, cells);
        }
    }
    return results;
}

}  // namespace

std::vector<Results> read_results(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Results> all;
    for (const auto& path : files) all.push_back(read(path));
    return all;
}

bool is_peer(const Time& time) {
    return !time.who.starts_with("steplab") && time.who != "machine" && time.who != "bare points" &&
           time.who != "nothing";
}

std::string ratio_text(const Time* ours, const Time* theirs) {
    return ours && theirs ? fmt::format("{:.2f}", theirs->step / ours->step) : "-";
}

std::string goal_text(std::string_view goal, bool reached) {
    return fmt::format("{}{}", goal, reached ? "" : " (missed)");
}

std::string goal_text(double goal, const Time* ours, const Time* theirs) {
    if (goal <= 0) return "";
    return goal_text(fmt::format("{:.1f}", goal), theirs->step >= goal * ours->step);
}

const Time* own(const Row& row, const std::string& precision) {
    return fastest(row, precision, [](const Time& time) { return time.who == "steplab"; });
}

const Time* own_with(const Row& row, const std::string& precision) {
    const Time* last = nullptr;  // rows are sorted by the number of threads
    if (!row.times.contains(precision)) return nullptr;
    for (const Time& time : row.times.at(precision)) {
        if (time.who.starts_with("steplab ")) last = &time;
    }
    return last;
}

double machine_time(const Row& row, const std::string& precision) {
    const Time* time = fastest(row, precision, [](const Time&) { return true; });
    if (!time) throw std::runtime_error("the results' row " + row.id + " has no time in " + precision);
    return time->particle;
}

std::vector<Bandwidth> bandwidths(const Results& results) {
    std::vector<Bandwidth> all;
    for (const Row* row : rows_of(results, "machine-memory"))  // y += c x: two reads, one write
        all.push_back({2 * sizeof(double) * row->particles, 3 * sizeof(double) / machine_time(*row, "double") * 1e9});
    return all;
}

std::vector<const Row*> rows_of(const Results& results, std::string_view id) {
    std::vector<const Row*> rows;
    for (const Row& row : results.rows) {
        if (row.id.starts_with(id)) rows.push_back(&row);
    }
    return rows;
}

}  // namespace steplab::docs
