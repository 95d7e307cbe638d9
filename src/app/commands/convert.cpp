#include "app/commands/convert.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "io/output_file.hpp"
#include "io/trajectory.hpp"
#include "io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* examples =
    "Examples:\n"
    "  steplab run --model chain --every 1 --out chain.trajectory\n"
    "  steplab convert chain.trajectory --out chain.xyz\n"
    "  steplab convert chain.trajectory | head";

class ConvertCommand final : public Command {
public:
    std::string_view name() const override { return "convert"; }
    std::string_view what() const override { return "Convert a trajectory file to CSV or XYZ"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE", "Trajectory file written by `steplab run`");
        text_option(app, "--out", out_, "FILE|-", "Output file (default -, standard output)");
        text_option(app, "--format", format_, "csv|xyz|trajectory",
                    "Format of --out (default: by its file name extension)");
        footer(app, [] { return std::string(examples); });
    }

    int run() override {
        if (file_.empty()) throw UsageError("FILE is required: the trajectory file to convert");
        const TrajectoryFormat format = format_.empty() ? trajectory_format_of(out_) : trajectory_format(format_);
        TrajectoryReader reader(file_);
        catch_interruptions();
        OutputFile file(out_);
        try {
            copy(reader, file, format);
        } catch (const Interrupted&) {
            if (const auto kept = file.keep_partial())
                std::fputs(fmt::format("steplab convert: interrupted; output so far is kept in '{}'\n", *kept).c_str(),
                           stderr);
            throw;
        }
        file.commit();
        if (!reader.complete()) refuse(reader);
        return static_cast<int>(ExitCode::done);
    }

private:
    static void copy(TrajectoryReader& reader, OutputFile& file, TrajectoryFormat format) {
        // Only the binary format describes the run; for the others its model need not be known here.
        const bool describes_run = format == TrajectoryFormat::trajectory;
        TrajectoryWriter writer(file, format, describes_run ? reader.run() : RunDescription(), reader.particles());
        Progress progress(reader.frames(), isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) == 0);
        Frame frame;
        for (std::uint64_t i = 0; i < reader.frames(); ++i) {
            check_interruption();
            reader.frame(i, frame);
            writer.add(frame);
            progress.at(i + 1);
        }
        writer.finish();
    }

    /// The frames are written; that the rest of the file cannot be read is an error nonetheless.
    [[noreturn]] void refuse(const TrajectoryReader& reader) const {
        throw FileError(fmt::format("'{}' is truncated or damaged after its first {} frames, which were written", file_,
                                    reader.frames()));
    }

    std::string file_;
    std::string out_ = "-";
    std::string format_;
};

}  // namespace

std::unique_ptr<Command> convert_command() { return std::make_unique<ConvertCommand>(); }

}  // namespace steplab
