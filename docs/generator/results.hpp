#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::docs {

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

/// A file that scripts/benchmark.sh wrote.
struct Results {
    std::string name;   ///< of the processor
    std::string about;  ///< lines "- key: value"
    std::vector<Row> rows;
};

/// All in the folder, by name. Throws std::runtime_error if a file is none.
std::vector<Results> read_results(const std::filesystem::path& folder);

/// The fastest of those that are wanted; null if there is none.
template <class Wanted>
const Time* fastest(const Row& row, const std::string& precision, Wanted wanted) {
    const Time* best = nullptr;
    if (!row.times.contains(precision)) return nullptr;
    for (const Time& time : row.times.at(precision)) {
        if (wanted(time) && (!best || time.step < best->step)) best = &time;
    }
    return best;
}

/// Whether it is somebody else's: neither steplab, nor a limit of the machine, nor a picture of bare points.
bool is_peer(const Time& time);

/// "2.50": how many times as fast as them we are; "-" if either is null.
std::string ratio_text(const Time* ours, const Time* theirs);

/// steplab itself, by one thread.
const Time* own(const Row& row, const std::string& precision);
/// steplab in another way, whose name goes on: by the most threads that were tried, in an ensemble, by a method; null
/// if there is none.
const Time* own_with(const Row& row, const std::string& precision);

/// ns that the machine takes at most for a number, in a row of its limits.
double machine_time(const Row& row, const std::string& precision);

/// What a core reads and writes, of so many bytes that it goes over again and again.
struct Bandwidth {
    double size = 0, bytes_a_second = 0;
};
std::vector<Bandwidth> bandwidths(const Results& results);

/// The rows whose id begins so, as the scene grows.
std::vector<const Row*> rows_of(const Results& results, std::string_view id);

}  // namespace steplab::docs
