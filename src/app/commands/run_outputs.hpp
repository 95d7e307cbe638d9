#pragma once

#include "io/output_file.hpp"
#include "io/series.hpp"
#include "io/summary.hpp"
#include "io/trajectory.hpp"
#include "sim/run/simulation.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// The options of `run` that say what is written where.
struct OutputOptions {
    std::string out;        ///< empty: no rows
    std::string format;     ///< empty: by the file's ending
    std::string particles;  ///< empty: all
    std::string series;     ///< empty: none
    std::string summary;    ///< empty: for people only

    void declare(CLI::App& app);
    /// Throws UsageError for options that make no sense together.
    void check() const;
    /// True if standard output belongs to rows, series or JSON.
    bool standard_output_taken() const;
    /// "chain.csv, energy.csv": the files that were asked for, as a person is told what was written.
    std::string files() const;
};

/// The files of one run: opened before anything is computed, written while it goes on, and put in place at its end.
class RunOutputs {
public:
    /// Throws UsageError for particles that are not there, FileError for files that cannot be written.
    RunOutputs(const OutputOptions& options, const RunDescription& description);

    /// Writes the rows of this moment. Nobody asked for any: nothing.
    void record(const Simulation& simulation);
    /// All rows are there: the files take their places, the summary last.
    void commit(const RunSummary& summary);
    /// The run was interrupted: what there is of the rows stays under other names, which are returned.
    std::vector<std::string> keep_partial();

private:
    void show_now_and_then();

    std::optional<OutputFile> rows_file_;
    std::optional<OutputFile> series_file_;
    std::optional<OutputFile> summary_file_;
    std::optional<TrajectoryWriter> rows_;
    std::optional<SeriesWriter> series_;
    bool watched_ = false;  ///< somebody may read the rows while they are made
    std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
    Frame frame_;
};

}  // namespace steplab
