#include "app/commands/ensemble_rows.hpp"

#include "app/cli/particle_list.hpp"
#include "core/error.hpp"
#include "io/number_append.hpp"
#include "sim/catalogue.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace steplab {

namespace {

void append_number_of(std::string& line, Precision precision, double value) {
    if (precision == Precision::float_) {
        append_number(line, static_cast<float>(value));
    } else {
        append_number(line, value);
    }
}

bool has_exact(const EnsembleRun& run) { return model(run.description.model).exact(run.description.scene) != nullptr; }

}  // namespace

EnsembleRows::EnsembleRows(const OutputOptions& options, std::span<const EnsembleRun> runs)
    : chosen_(options.particles) {
    if (!options.out.empty()) {
        const TrajectoryFormat format =
            options.format.empty() ? trajectory_format_of(options.out) : trajectory_format(options.format);
        if (format != TrajectoryFormat::csv)
            throw UsageError("--out of an ensemble must be CSV: no other format has a column for the run");
        rows_file_.emplace(options.out);
        rows_file_->at_program_end(UnfinishedFile::AtEnd::kept_in_lines);
        rows_file_->write("run,step,time,particle,x,y,z,vx,vy,vz\n");
    }
    if (!options.series.empty()) {
        series_file_.emplace(options.series);
        const auto drags = [](const EnsembleRun& run) { return has_drag(run.description); };
        series_.emplace(*series_file_,
                        SeriesWriter::Columns{.error = std::any_of(runs.begin(), runs.end(), has_exact),
                                              .energy_error = std::none_of(runs.begin(), runs.end(), drags),
                                              .run = true});
    }
}

void EnsembleRows::begin(std::size_t run, const RunDescription& description) {
    run_ = run;
    const auto count = static_cast<std::size_t>(model(description.model).particles(description.scene));
    if (!chosen_.empty()) {
        particles_ = parse_particles(chosen_, count);
    } else {
        particles_.resize(count);
        std::iota(particles_.begin(), particles_.end(), std::size_t(0));
    }
}

void EnsembleRows::record(const Simulation& simulation) {
    if (series_) series_->add(simulation.step(), simulation.time(), simulation.diagnostics(), run_);
    if (!rows_file_) return;
    simulation.frame(frame_);
    write_rows();
}

void EnsembleRows::write_rows() {
    std::string moment, line;
    append_number(moment, run_);
    moment += ',';
    append_number(moment, frame_.step);
    moment += ',';
    append_number(moment, frame_.time);
    for (const std::size_t particle : particles_) {
        line = moment + ',';
        append_number(line, particle);
        for (const Vec3& vector : {frame_.positions[particle], frame_.velocities[particle]}) {
            for (const double value : {vector.x, vector.y, vector.z}) {
                line += ',';
                append_number_of(line, frame_.precision, value);
            }
        }
        rows_file_->write(line + '\n');
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
