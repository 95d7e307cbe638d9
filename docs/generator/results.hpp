#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::docs {

/// The time of a step of one program, or of another quantity that a row measures.
struct Time {
    std::string who;                ///< the program: "steplab", "odeint gather"
    double step = 0, particle = 0;  ///< ns per step; ns per step and particle
};

struct Row {
    std::string id, method;
    double particles = 0;
    std::map<std::string, std::vector<Time>> times;  ///< by precision
};

/// The contents of a file that scripts/benchmark.sh wrote.
struct Results {
    std::string name;   ///< of the processor: the file's name without its ending
    std::string about;  ///< processor, compiler, commit: lines "- key: value"
    std::vector<Row> rows;
};

/// All results in the folder, sorted by name. Throws std::runtime_error if a line of a file has too few cells.
std::vector<Results> read_results(const std::filesystem::path& folder);

/// The fastest of the times for which `wanted` is true; null if there is none.
template <class Wanted>
const Time* fastest(const Row& row, const std::string& precision, Wanted wanted) {
    const Time* best = nullptr;
    if (!row.times.contains(precision)) return nullptr;
    for (const Time& time : row.times.at(precision)) {
        if (wanted(time) && (!best || time.step < best->step)) best = &time;
    }
    return best;
}

/// Whether the time is that of a peer: not of steplab, of a limit of the machine, of a bare draw of points or of an
/// empty process.
bool is_peer(const Time& time);

/// "2.50": the speed-up of `ours` over `theirs`; "-" if either is null.
std::string ratio_text(const Time* ours, const Time* theirs);

/// "2.0", or "2.0 (missed)": a goal and whether it is reached.
std::string goal_text(std::string_view goal, bool reached);
/// The same for a goal for the speed-up of `ours` over `theirs`; empty if the goal is 0 (none was set). Neither may be
/// null where there is a goal.
std::string goal_text(double goal, const Time* ours, const Time* theirs);

/// steplab on one thread.
const Time* own(const Row& row, const std::string& precision);
/// steplab in a variant, "steplab 2 threads": on the largest number of threads measured, in an ensemble, by a named
/// method; null if there is none.
const Time* own_with(const Row& row, const std::string& precision);

/// ns per number in a row that measures a limit of the machine.
double machine_time(const Row& row, const std::string& precision);

/// The memory bandwidth of one core in repeated passes over a working set.
struct Bandwidth {
    double size = 0;              ///< of the working set, bytes
    double bytes_per_second = 0;  ///< read and written
};
std::vector<Bandwidth> bandwidths(const Results& results);

/// The rows whose id begins with `id`, in the order of the file.
std::vector<const Row*> rows_of(const Results& results, std::string_view id);

}  // namespace steplab::docs
