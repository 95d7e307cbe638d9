#include "app/commands/convert.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "core/error.hpp"
#include "io/interruption.hpp"
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
    std::string_view what() const override { return "Write a trajectory file as CSV or XYZ"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE", "A trajectory that `steplab run` wrote");
        text_option(app, "--out", out_, "FILE|-", "Where to (default -, standard output)");
        text_option(app, "--format", format_, "csv|xyz|trajectory", "Of --out (default: by the file's ending)");
        footer(app, [] { return std::string(examples); });
    }

    int run() override {
        if (file_.empty()) throw UsageError("name the trajectory file to convert");
        const TrajectoryFormat format = format_.empty() ? trajectory_format_of(out_) : trajectory_format(format_);
        TrajectoryReader reader(file_);
        catch_interruptions();
        OutputFile file(out_);
        try {
            copy(reader, file, format);
        } catch (const Interrupted&) {
            if (const auto kept = file.keep_partial())
                std::fputs(
                    fmt::format("steplab convert: interrupted; what was written is kept as '{}'\n", *kept).c_str(),
                    stderr);
            throw;
        }
        file.commit();
        if (!reader.complete()) refuse(reader);
        return static_cast<int>(ExitCode::done);
    }

private:
    static void copy(TrajectoryReader& reader, OutputFile& file, TrajectoryFormat format) {
        // Only the binary format tells of the run, which need not be known here for the others.
        const bool tells_run = format == TrajectoryFormat::trajectory;
        TrajectoryWriter writer(file, format, tells_run ? reader.run() : RunDescription(), reader.particles());
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

    /// The frames are out; that there were more of them is an error all the same.
    [[noreturn]] void refuse(const TrajectoryReader& reader) const {
        throw FileError(fmt::format("'{}' is cut short or damaged after its first {} frames: these were written", file_,
                                    reader.frames()));
    }

    std::string file_;
    std::string out_ = "-";
    std::string format_;
};

}  // namespace

std::unique_ptr<Command> convert_command() { return std::make_unique<ConvertCommand>(); }

}  // namespace steplab
