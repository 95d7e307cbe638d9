#pragma once

#include "app/commands/run_outputs.hpp"
#include "sim/ensemble/ensemble.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// The rows of --out and --series of an ensemble, as CSV: those of single runs, one run after another, each row
/// preceded by the number of its run.
class EnsembleRows {
public:
    /// Throws UsageError for a format without such a column, FileError for files that cannot be written.
    EnsembleRows(const OutputOptions& options, std::span<const EnsembleRun> runs);

    /// True if rows are to be written.
    bool wanted() const { return rows_file_ || series_file_; }
    /// Begins the rows of this run. Throws UsageError for particles that it does not have.
    void begin(std::size_t run, const RunDescription& description);
    /// Writes the rows of the present step.
    void record(const Simulation& simulation);
    /// All rows are written: puts the files in place.
    void commit();
    /// The ensemble was interrupted: keeps the rows written so far under other names, which are returned.
    std::vector<std::string> keep_partial();

private:
    void write_rows();

    std::string chosen_;  ///< --particles
    std::optional<OutputFile> rows_file_;
    std::optional<OutputFile> series_file_;
    std::optional<SeriesWriter> series_;
    Columns columns_;
    FrameParts needs_;
    std::size_t run_ = 0;
    ParticleChoice particles_;  ///< of the present run
    Frame frame_;
};

}  // namespace steplab
