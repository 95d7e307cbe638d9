#include "app/commands/run_outputs.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/particle_list.hpp"
#include "app/cli/standard_streams.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace steplab {

void OutputOptions::declare(CLI::App& app) {
    const std::string group = "Output";
    text_option(app, "--out", out, "FILE|-", "Positions and velocities; - for standard output", group);
    text_option(app, "--format", format, "csv|xyz|trajectory", "Format of --out (default: by its file name extension)",
                group);
    text_option(app, "--particles", particles, "9,0-3", "Particles in --out (default all)", group);
    text_option(app, "--columns", columns, "x,ux,...", columns_help, group);
    text_option(app, "--series", series, "FILE", "Energy, momentum and other diagnostics over time (CSV)", group);
    text_option(app, "--observables", observables, "kT,pressure,msd",
                "Further columns of --series: temperature, pressure by the virial, mean squared displacement", group);
    text_option(app, "--summary", summary, "FILE|-", "Summary of the run (JSON)", group);
}

void OutputOptions::check() const {
    if (out.empty() && !format.empty()) throw UsageError("--format is that of --out, but there is no --out");
    if (out.empty() && !particles.empty())
        throw UsageError("--particles selects those in --out, but there is no --out");
    if (out.empty() && !columns.empty()) throw UsageError("--columns selects those of --out, but there is no --out");
    if (series.empty() && !observables.empty())
        throw UsageError("--observables adds columns to --series, but there is no --series");
    const std::array<std::pair<std::string_view, const std::string*>, 3> files{
        {{"--out", &out}, {"--series", &series}, {"--summary", &summary}}};
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const std::string& a = *files[j].second;
            const std::string& b = *files[i].second;
            if (a.empty() || b.empty() || !same_output(a, b)) continue;
            const std::string where = b == "-" ? "standard output" : fmt::format("'{}'", shown(b));
            throw UsageError(fmt::format("{} and {} both write to {}: give each a file of its own", files[j].first,
                                         files[i].first, where));
        }
    }
}

TrajectoryFormat OutputOptions::rows_format() const {
    const TrajectoryFormat rows = format.empty() ? trajectory_format_of(out) : trajectory_format(format);
    check_compression(rows, out);
    check_columns(rows, chosen_columns());
    return rows;
}

Columns OutputOptions::chosen_columns() const { return columns.empty() ? Columns() : parse_columns(columns); }

bool OutputOptions::standard_output_taken() const { return out == "-" || series == "-" || summary == "-"; }

std::string OutputOptions::files() const {
    std::string text;
    for (const std::string& file : {out, series, summary}) {
        if (!file.empty() && file != "-") text += (text.empty() ? "" : ", ") + shown(file);
    }
    return text;
}

void OutputOptions::print_summary(std::string text) const {
    if (const std::string names = files(); !names.empty()) text += fmt::format("  {:<14}{}\n", "written", names);
    print_beside(text, standard_output_taken());
}

bool knows_energy_error(const RunDescription& description) {
    return !has_drag(description) || integrates_drag_work(description);
}

void print_interruption(std::string text, const std::vector<std::string>& kept) {
    if (!kept.empty()) text += fmt::format("; output so far is kept in '{}'", fmt::join(kept, "' and '"));
    print_aside(fmt::format("steplab run: {}\n", text));
}

RunOutputs::RunOutputs(const OutputOptions& options, const RunDescription& description) {
    const Model& scene = model_of(description);
    if (!options.out.empty()) {
        const TrajectoryFormat format = options.rows_format();
        const auto count = static_cast<std::size_t>(scene.particles(description.scene));
        RowOptions rows{.columns = options.chosen_columns()};
        if (!options.particles.empty()) rows.particles = parse_particles("--particles", options.particles, count);
        rows_file_.emplace(options.out, compression_of(options.out));
        rows_.emplace(*rows_file_, format, description, std::move(rows));
        streamed_ = written_directly(options.out);
    }
    if (!options.series.empty()) {
        std::vector<std::string> more;
        if (!options.observables.empty()) {
            observables_.emplace(plan_of(as_held(description)), parse_observables(options.observables));
            for (const Observable observable : observables_->wanted()) more.emplace_back(id(observable));
        }
        series_file_.emplace(options.series, compression_of(options.series));
        series_.emplace(*series_file_, SeriesWriter::Columns{.error = exact_of(description) != nullptr,
                                                             .energy_error = knows_energy_error(description),
                                                             .more = std::move(more)});
    }
    if (!options.summary.empty()) summary_file_.emplace(options.summary, compression_of(options.summary));
}

void RunOutputs::record(const Simulation& simulation) {
    if (series_) {
        const auto more = observables_ ? observables_->of(simulation.state()) : std::vector<std::optional<double>>();
        series_->add(simulation.step(), simulation.time(), simulation.diagnostics(), 0, more);
    }
    if (!rows_) return;
    simulation.frame(frame_, rows_->needs());
    rows_->add(frame_);
    if (streamed_) flush_at_intervals();
}

void RunOutputs::flush_at_intervals() {
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < std::chrono::milliseconds(200)) return;
    flushed_ = now;
    rows_->flush();
    rows_file_->flush();
}

void RunOutputs::commit(const RunSummary& summary) {
    if (rows_) rows_->finish();
    if (rows_file_) rows_file_->commit();
    if (series_file_) series_file_->commit();
    if (!summary_file_) return;
    summary_file_->write(summary_json(summary));
    summary_file_->commit();
}

std::vector<std::string> RunOutputs::keep_partial() {
    std::vector<std::string> kept;
    const auto keep = [&kept](OutputFile& file) {
        if (auto name = file.keep_partial()) kept.push_back(std::move(*name));
    };
    if (rows_ && !streamed_) rows_->finish();  // a pipe whose reader sleeps would block
    if (rows_file_) keep(*rows_file_);
    if (series_file_) keep(*series_file_);
    return kept;
}

}  // namespace steplab
