#include "app/commands/ensemble_rows.hpp"

#include "app/cli/particle_list.hpp"
#include "core/error.hpp"
#include "io/trajectory_text.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace steplab {

namespace {

bool has_exact(const EnsembleRun& run) { return exact_of(run.description) != nullptr; }

}  // namespace

EnsembleRows::EnsembleRows(const OutputOptions& options, std::span<const EnsembleRun> runs)
    : chosen_(options.particles) {
    if (!options.out.empty()) {
        const TrajectoryFormat format = options.rows_format();
        if (format != TrajectoryFormat::csv)
            throw UsageError("--out of an ensemble must be CSV: no other format has a column for the run");
        columns_ = options.columns.empty() ? usual_columns() : options.chosen_columns();
        needs_ = parts_of(columns_);
        rows_file_.emplace(options.out, compression_of(options.out));
        rows_file_->at_program_end(UnfinishedFile::AtEnd::kept_in_lines);
        rows_file_->write("run," + csv_header(columns_));
    }
    if (!options.series.empty()) {
        series_file_.emplace(options.series, compression_of(options.series));
        const auto is_known = [](const EnsembleRun& run) { return knows_energy_error(run.description); };
        series_.emplace(*series_file_,
                        SeriesWriter::Columns{.error = std::any_of(runs.begin(), runs.end(), has_exact),
                                              .energy_error = std::all_of(runs.begin(), runs.end(), is_known),
                                              .run = true});
    }
}

void EnsembleRows::begin(std::size_t run, const RunDescription& description) {
    run_ = run;
    if (chosen_.empty()) return;
    const auto count = static_cast<std::size_t>(model_of(description).particles(description.scene));
    particles_ = std::make_shared<const std::vector<std::size_t>>(parse_particles("--particles", chosen_, count));
}

void EnsembleRows::record(const Simulation& simulation) {
    if (series_) series_->add(simulation.step(), simulation.time(), simulation.diagnostics(), run_);
    if (!rows_file_) return;
    simulation.frame(frame_, needs_);
    write_rows();
}

void EnsembleRows::write_rows() {
    constexpr std::size_t most = 4096;
    const std::size_t all = FrameBlock::rows_of(frame_, particles_);
    const std::string begin = std::to_string(run_) + ',';
    std::string text;
    for (std::size_t first = 0; first < all; first += most) {
        FrameBlock block;
        block.append(frame_, needs_, particles_, first, std::min(most, all - first));
        text.clear();
        append_csv(text, block, columns_, begin);
        rows_file_->write(text);
    }
}

void EnsembleRows::commit() {
    if (rows_file_) rows_file_->commit();
    if (series_file_) series_file_->commit();
}

std::vector<std::string> EnsembleRows::keep_partial() {
    std::vector<std::string> kept;
    for (auto* const file : {&rows_file_, &series_file_}) {
        if (!*file) continue;
        if (auto name = (*file)->keep_partial()) kept.push_back(std::move(*name));
    }
    return kept;
}

}  // namespace steplab
