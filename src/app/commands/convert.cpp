#include "app/commands/convert.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/named_text.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "io/compression.hpp"
#include "io/dump_text.hpp"
#include "io/output_file.hpp"
#include "io/same_columns.hpp"
#include "io/springs_beside.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "io/vtk_series.hpp"
#include "io/whole_frames.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
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
    "  steplab convert chain.xyz.gz --out chain.csv\n"
    "  steplab convert chain.trajectory --out chain.pvd\n"
    "  steplab convert dump.lammpstrj.gz --out atoms.xyz\n"
    "  steplab convert chain.xyz --model chain --out chain.trajectory";

/// What is written by whole frames: a LAMMPS dump, or files of VTK.
enum class FrameFormat { dump, pvd };

constexpr std::array<std::string_view, 2> frame_formats{"dump", "pvd"};

/// By its name, or the ending of a file; none of another one.
std::optional<FrameFormat> frame_format(const std::string& name, const std::string& out) {
    const std::string format = name.empty() ? extension_of(without_compression(out)) : name;
    if (format == "dump" || (name.empty() && format == "lammpstrj")) return FrameFormat::dump;
    if (format == "pvd") return FrameFormat::pvd;
    return std::nullopt;
}

class ConvertCommand final : public Command {
public:
    std::string_view name() const override { return "convert"; }
    std::string_view what() const override { return "Convert the rows of a run to another format"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE",
                    "Trajectory, CSV, extended XYZ or LAMMPS dump (text), also .gz and .zst");
        text_option(app, "--out", out_, "FILE|-", "Output file (default -, standard output)");
        text_option(app, "--format", format_, "csv|xyz|trajectory|dump|pvd",
                    "Format of --out (default: by its file name extension)");
        text_option(app, "--columns", columns_, "x,ux,...", columns_help);
        scene_.declare(app);
        footer(app, [] { return std::string(examples) + "\n\n" + catalogue_hint(); });
    }

    int run() override {
        if (file_.empty()) throw UsageError("FILE is required: the file to convert");
        convert();
        tell_units();
        if (fault_) throw FileError(*fault_);
        return static_cast<int>(ExitCode::done);
    }

private:
    void convert() {
        if (const auto format = frame_format(format_, out_)) return convert_frames(*format);
        const TrajectoryFormat format =
            format_.empty() ? trajectory_format_of(out_, frame_formats) : trajectory_format(format_, frame_formats);
        const Columns columns = columns_.empty() ? Columns() : parse_columns(columns_);
        check_compression(format, out_);
        check_columns(format, columns);
        InputFile input(file_);
        catch_interruptions();
        if (scene_.any_given() && (format != TrajectoryFormat::trajectory || TrajectoryReader::reads(input)))
            throw UsageError("the options of a scene are for a text that is to become a trajectory: leave them out");
        if (TrajectoryReader::reads(input)) {
            convert(TrajectoryReader(std::move(input)), format, columns);
        } else {
            convert(*TextTrajectory::open(TextInput(std::move(input)), TextTrajectory::From::any_program), format,
                    columns);
        }
    }

    void convert_frames(FrameFormat format) {
        if (!columns_.empty()) throw UsageError("--columns selects those of CSV and XYZ");
        if (scene_.any_given())
            throw UsageError("the options of a scene are for a text that is to become a trajectory: leave them out");
        if (format == FrameFormat::pvd && out_ == "-")
            throw UsageError("--format pvd writes several files: --out NAME.pvd");
        catch_interruptions();
        if (format == FrameFormat::pvd) {
            VtkSeries series(out_);
            const auto shape = known_shape();
            each_frame([&, joined = false](const FrameBlock& frame) mutable {
                if (!std::exchange(joined, true)) series.join(shape ? *shape : shape_beside(frame));
                series.add(frame);
            });
            series.finish();
        } else {
            write([&](OutputFile& file) {
                each_frame([&, text = std::string()](const FrameBlock& frame) mutable {
                    text.clear();
                    append_dump(text, frame);
                    file.write(text);
                });
            });
        }
    }

    /// That of the run that wrote the file, if the file has all of its particles; of a text, the bonds that lie beside
    /// it.
    std::optional<Shape> known_shape() const {
        InputFile input(file_);
        if (!TrajectoryReader::reads(input)) return std::nullopt;
        const TrajectoryReader reader(std::move(input));
        try {
            const RunDescription run = reader.run();
            const Shape shape = model_of(run).shape(run.scene);
            return shape.rest.size() == reader.rows() ? std::optional(shape) : std::nullopt;
        } catch (const FileError&) {  // of a scene that this program does not know
            return std::nullopt;
        }
    }

    /// What springs lie beside a file of which no scene is known, whose first frame this is.
    Shape shape_beside(const FrameBlock& first) const {
        Shape shape;
        shape.springs = springs_beside(file_, first.particles, first.positions);
        shape.rest.resize(first.rows);
        shape.box = first.scene.box;
        return shape;
    }

    /// Only dumps name the units of their numbers.
    void tell_units() const {
        if (units_.empty() || units_ == "lj" || frame_format(format_, out_) == FrameFormat::dump) return;
        print_note("steplab convert", fmt::format("the numbers of '{}' are in LAMMPS' units {} and stay as they are",
                                                  shown(file_), units_));
    }

    /// All frames of a text, or those before a fault, which is returned. Throws it if there are none. `same`: what
    /// their columns have to be.
    template <class Visit>
    std::optional<FileError> each_before_a_fault(TextTrajectory& text, const Visit& visit,
                                                 std::optional<SameColumns> same = {}) {
        std::uint64_t frames = 0;
        for (FrameBlock frame;; ++frames) {
            check_interruption();
            try {
                if (!text.next(frame)) return std::nullopt;
                if (same) same->check(file_, frame);
            } catch (const FileError& fault) {
                if (frames == 0) throw;
                return behind(fault, frames);
            }
            units_ = frame.scene.units;
            visit(frame);
        }
    }

    /// The same of a trajectory. A fault between its frames is kept, that of its end is told by check_complete().
    template <class Visit>
    void each_before_a_fault(TrajectoryReader& reader, const Visit& visit) {
        std::uint64_t frames = 0;
        try {
            reader.each_block([&](FrameBlock block) {
                check_interruption();
                const std::uint64_t until = block.first_frame + block.moments.size();
                visit(std::move(block));
                frames = until;
            });
        } catch (const FileError& fault) {
            if (frames == 0) throw;
            fault_ = behind(fault, frames);
        }
    }

    static FileError behind(const FileError& fault, std::uint64_t frames) {
        return FileError(fmt::format("{}; the {} before it {} written", fault.what(),
                                     frames == 1 ? "frame" : fmt::format("{} frames", frames),
                                     frames == 1 ? "was" : "were"));
    }

    /// All that can be read, whole.
    void each_frame(const WholeFrames::Visit& visit) {
        WholeFrames frames(visit);
        InputFile input(file_);
        if (!TrajectoryReader::reads(input)) {
            const auto text = TextTrajectory::open(TextInput(std::move(input)), TextTrajectory::From::any_program);
            text->require({Column::x, Column::y, Column::z});
            fault_ = each_before_a_fault(*text, [&](const FrameBlock& frame) { frames.add(frame); });
            return;
        }
        TrajectoryReader reader(std::move(input));
        check_holds_frames(reader);
        each_before_a_fault(reader, [&](FrameBlock block) {
            block.complete({.positions = true});
            frames.add(block);
        });
        check_complete(reader);
    }

    void check_holds_frames(const TrajectoryReader& reader) const {
        if (reader.frames() == 0)
            throw FileError(fmt::format("'{}' holds no whole frame: it is truncated or damaged", shown(file_)));
    }

    /// The frames are written; that the rest of the file cannot be read is an error nonetheless.
    void check_complete(const TrajectoryReader& reader) const {
        if (!reader.complete())
            throw FileError(fmt::format("'{}' is truncated or damaged after its first {} frames, which were written",
                                        shown(file_), reader.frames()));
    }

    void convert(TrajectoryReader reader, TrajectoryFormat format, const Columns& columns) {
        if (format != TrajectoryFormat::trajectory) reader.require(columns);
        check_holds_frames(reader);
        write([&](OutputFile& file) {
            TrajectoryWriter writer(file, format, {}, {.columns = columns});
            if (format == TrajectoryFormat::trajectory) writer.describe(reader.version(), reader.description());
            Progress progress(reader.frames(), isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) == 0);
            each_before_a_fault(reader, [&](FrameBlock block) {
                progress.at(block.first_frame + block.moments.size());
                writer.add(std::move(block));
            });
            writer.finish();
        });
        check_complete(reader);
    }

    /// Only a trajectory file describes its run. Without --columns a CSV file gets those that the other has.
    void convert(TextTrajectory& text, TrajectoryFormat format, Columns columns) {
        if (format == TrajectoryFormat::trajectory) return convert_to_trajectory(text);
        const bool all = columns.empty();
        if (all) columns = text.columns();
        if (format == TrajectoryFormat::xyz) check_columns(format, columns);
        text.require(columns);
        write([&](OutputFile& file) {
            TrajectoryWriter writer(file, format, {}, {.columns = columns});
            const auto add = [&](FrameBlock& frame) {
                if (!all) frame.values.clear();
                writer.add(std::move(frame));
            };
            fault_ = each_before_a_fault(text, add, SameColumns(columns, all));
            writer.finish();
        });
    }

    /// A trajectory file describes its run, of which the text says nothing.
    void convert_to_trajectory(TextTrajectory& text) {
        if (!scene_.any_given())
            throw UsageError(
                fmt::format("'{}' is text, which does not describe its run as a trajectory file must: name "
                            "its scene (--model or --scene, --set, --method, --dt), or --format csv or xyz",
                            shown(file_)));
        const RunDescription run = as_held(scene_.description());
        text.require({Column::x, Column::y, Column::z, Column::vx, Column::vy, Column::vz});
        NamedText named(file_, run);
        write([&](OutputFile& file) {
            TrajectoryWriter writer(file, TrajectoryFormat::trajectory, run);
            WholeFrames frames([&](const FrameBlock& frame) { writer.add(named.frame(frame, writer.needs())); });
            fault_ = each_before_a_fault(
                text, [&](const FrameBlock& frame) { frames.add(frame); }, SameColumns(usual_columns(), false));
            writer.finish();
        });
        if (!named.left_out().empty())
            print_note("steplab convert",
                       fmt::format("trajectory files have no columns for what is left out: {}", named.left_out()));
    }

    /// Puts a file in place that `rows` writes, or keeps what an interruption leaves of it.
    template <class Rows>
    void write(const Rows& rows) const {
        OutputFile file(out_, compression_of(out_));
        try {
            rows(file);
        } catch (const Interrupted&) {
            if (const auto kept = file.keep_partial())
                print_aside(fmt::format("steplab convert: interrupted; output so far is kept in '{}'\n", shown(*kept)));
            throw;
        }
        file.commit();
    }

    std::string file_;
    std::string out_ = "-";
    std::string format_;
    std::string columns_;
    SceneOptions scene_;
    std::string units_;               ///< of a text, if it says so
    std::optional<FileError> fault_;  ///< of the file, found when what is before it was written
};

}  // namespace

std::unique_ptr<Command> convert_command() { return std::make_unique<ConvertCommand>(); }

}  // namespace steplab
