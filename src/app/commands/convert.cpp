#include "app/commands/convert.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "io/compression.hpp"
#include "io/output_file.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory.hpp"
#include "io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr const char* examples =
    "Examples:\n"
    "  steplab run --model chain --every 1 --out chain.trajectory\n"
    "  steplab convert chain.trajectory --out chain.xyz.gz\n"
    "  steplab convert chain.trajectory --columns ux,uy,uz | head\n"
    "  steplab convert chain.xyz.gz --out chain.csv";

class ConvertCommand final : public Command {
public:
    std::string_view name() const override { return "convert"; }
    std::string_view what() const override { return "Convert the rows of a run to another format"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE", "File written by `steplab run --out`: trajectory, CSV or XYZ");
        text_option(app, "--out", out_, "FILE|-", "Output file (default -, standard output)");
        text_option(app, "--format", format_, "csv|xyz|trajectory",
                    "Format of --out (default: by its file name extension)");
        text_option(app, "--columns", columns_, "x,ux,...", columns_help);
        footer(app, [] { return std::string(examples); });
    }

    int run() override {
        if (file_.empty()) throw UsageError("FILE is required: the file to convert");
        const TrajectoryFormat format = format_.empty() ? trajectory_format_of(out_) : trajectory_format(format_);
        const Columns columns = columns_.empty() ? Columns() : parse_columns(columns_);
        check_compression(format, out_);
        check_columns(format, columns);
        InputFile input(file_);
        catch_interruptions();
        if (TrajectoryReader::reads(input)) {
            convert(TrajectoryReader(std::move(input)), format, columns);
        } else {
            convert(*TextTrajectory::open(std::move(input)), format, columns);
        }
        return static_cast<int>(ExitCode::done);
    }

private:
    void convert(TrajectoryReader reader, TrajectoryFormat format, const Columns& columns) const {
        if (format != TrajectoryFormat::trajectory) reader.require(columns);
        if (reader.frames() == 0)
            throw FileError(fmt::format("'{}' holds no whole frame: it is truncated or damaged", shown(file_)));
        write([&](OutputFile& file) {
            TrajectoryWriter writer(file, format, {}, {.columns = columns});
            if (format == TrajectoryFormat::trajectory) writer.describe(reader.version(), reader.description());
            Progress progress(reader.frames(), isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) == 0);
            reader.each_block([&](FrameBlock block) {
                check_interruption();
                progress.at(block.first_frame + block.moments.size());
                writer.add(std::move(block));
            });
            writer.finish();
        });
        // The frames are written; that the rest of the file cannot be read is an error nonetheless.
        if (!reader.complete())
            throw FileError(fmt::format("'{}' is truncated or damaged after its first {} frames, which were written",
                                        shown(file_), reader.frames()));
    }

    /// Only a trajectory file describes its run. Without --columns a CSV file gets those that the other has.
    void convert(TextTrajectory& text, TrajectoryFormat format, Columns columns) const {
        if (format == TrajectoryFormat::trajectory)
            throw UsageError(
                fmt::format("'{}' is text, which does not describe its run as a trajectory file must: "
                            "--format csv or xyz",
                            shown(file_)));
        if (columns.empty()) columns = text.columns();
        if (format == TrajectoryFormat::xyz) check_columns(format, columns);
        text.require(columns);
        write([&](OutputFile& file) {
            TrajectoryWriter writer(file, format, {}, {.columns = columns});
            for (FrameBlock frame; text.next(frame);) {
                check_interruption();
                writer.add(std::move(frame));
            }
            writer.finish();
        });
    }

    /// Puts a file in place that `rows` writes, or keeps what an interruption leaves of it.
    template <class Rows>
    void write(const Rows& rows) const {
        OutputFile file(out_, compression_of(out_));
        try {
            rows(file);
        } catch (const Interrupted&) {
            if (const auto kept = file.keep_partial())
                std::fputs(
                    fmt::format("steplab convert: interrupted; output so far is kept in '{}'\n", shown(*kept)).c_str(),
                    stderr);
            throw;
        }
        file.commit();
    }

    std::string file_;
    std::string out_ = "-";
    std::string format_;
    std::string columns_;
};

}  // namespace

std::unique_ptr<Command> convert_command() { return std::make_unique<ConvertCommand>(); }

}  // namespace steplab
