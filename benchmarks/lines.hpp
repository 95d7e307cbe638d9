#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::benchmark {

/// A line of benchmarks/results: somebody's ns for each step, picture, frame or whole run, in which `count` particles,
/// numbers or bytes are computed.
struct ResultLine {
    std::string_view row, method, precision;
    double count;
    std::string_view who;
    double ns;
    std::string_view hash = "";  ///< of the state that steplab's results end with
};

inline std::string text(const ResultLine& line) {
    return fmt::format("{},{},{},{:.0f},{},{:.2f},{:.4f},{}\n", line.row, line.method, line.precision, line.count,
                       line.who, line.ns, line.ns / line.count, line.hash);
}

inline void print(const ResultLine& line) { fmt::print("{}", text(line)); }

/// Whether the words of a command line ask for such lines in place of text for people; the word is taken off them.
inline bool wants_lines(std::vector<std::string>& words) { return std::erase(words, "--lines") > 0; }

}  // namespace steplab::benchmark
