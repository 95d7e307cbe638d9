#pragma once

#include "io/output_file.hpp"
#include "io/series.hpp"
#include "io/summary.hpp"
#include "io/trajectory.hpp"
#include "sim/run/observables.hpp"
#include "sim/run/simulation.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// The options of `run` for its output files.
struct OutputOptions {
    std::string out;          ///< empty: no rows
    std::string format;       ///< empty: by the file name extension
    std::string particles;    ///< empty: all
    std::string columns;      ///< empty: the usual ones
    std::string series;       ///< empty: none
    std::string summary;      ///< empty: only the text for people
    std::string observables;  ///< of --series; empty: none

    void declare(CLI::App& app);
    /// Throws UsageError for options that contradict each other.
    void check() const;
    /// The format of --out, which is given. Throws UsageError if it does not go with the other options.
    TrajectoryFormat rows_format() const;
    /// Those of --out; empty: the usual ones.
    Columns chosen_columns() const;
    /// True if standard output belongs to rows, series or JSON.
    bool standard_output_taken() const;
    /// True if energy errors are written.
    bool asks_for_energy_error() const { return !series.empty() || !summary.empty(); }
    /// "chain.csv, energy.csv": the names of the files to write.
    std::string files() const;
    /// Prints a summary for people, with the names of the files: to standard output, or to standard error if standard
    /// output is taken.
    void print_summary(std::string text) const;
};

/// False if drag takes energy that the method does not count.
bool knows_energy_error(const RunDescription& description);

/// Prints "steplab run: interrupted after step 5; output so far is kept in 'a.csv.partial'" to standard error.
void print_interruption(std::string text, const std::vector<std::string>& kept);

/// The files of one run: opened before the run begins, written during it, and put in place at its end.
class RunOutputs {
public:
    /// Throws UsageError for particles that do not exist, FileError for files that cannot be written.
    RunOutputs(const OutputOptions& options, const RunDescription& description);

    /// Writes the rows of the present step to --out and --series, if given.
    void record(const Simulation& simulation);
    /// All rows are written: puts the files in place, the summary last.
    void commit(const RunSummary& summary);
    /// The run was interrupted: keeps the rows written so far under other names, which are returned.
    std::vector<std::string> keep_partial();

private:
    /// Hands rows to the reader of a pipe or terminal some times a second.
    void flush_at_intervals();

    std::optional<OutputFile> rows_file_;
    std::optional<OutputFile> series_file_;
    std::optional<OutputFile> summary_file_;
    std::optional<TrajectoryWriter> rows_;
    std::optional<SeriesWriter> series_;
    std::optional<Observables> observables_;
    bool streamed_ = false;  ///< the rows go to a pipe, a terminal or a device
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
    Frame frame_;
};

}  // namespace steplab
