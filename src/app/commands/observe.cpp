#include "app/commands/observe.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/compression.hpp"
#include "io/output_file.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "sim/run/radial_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr ParameterInfo bins_info{.name = "--bins",
                                  .kind = ParameterInfo::Kind::integer,
                                  .unit = "",
                                  .minimum = 1,
                                  .maximum = 1000000,
                                  .what = "number of distances"};

class ObserveCommand final : public Command {
public:
    std::string_view name() const override { return "observe"; }
    std::string_view what() const override { return "Measure the frames of a trajectory: --rdf"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE", "File written by `steplab run --out`: trajectory or XYZ");
        flag_option(app, "--rdf", rdf_, "Radial distribution function g(r), averaged over the frames, as CSV");
        text_option(app, "--bins", bins_, "N", "Number of distances up to half the box's shortest side (default 200)");
        text_option(app, "--out", out_, "FILE|-", "Output file (default -, standard output)");
    }

    int run() override {
        if (file_.empty()) throw UsageError("FILE is required: the trajectory to measure");
        if (!rdf_) throw UsageError("--rdf is required: what is to be measured");
        const auto bins = static_cast<std::size_t>(parse_value(bins_info, bins_));
        InputFile input(file_);
        catch_interruptions();
        if (TrajectoryReader::reads(input)) {
            measure(TrajectoryReader(std::move(input)), bins);
        } else {
            measure(*TextTrajectory::open(std::move(input)), bins);
        }
        write();
        return static_cast<int>(ExitCode::done);
    }

private:
    void measure(TrajectoryReader reader, std::size_t bins) {
        Progress progress(reader.frames(), isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) == 0);
        Frame frame;
        for (std::uint64_t i = 0; i < reader.frames(); ++i) {
            reader.frame(i, frame);
            add(frame.positions, reader.scene().box, bins);
            progress.at(i + 1);
        }
    }

    void measure(TextTrajectory& text, std::size_t bins) {
        text.require({Column::x, Column::y, Column::z});
        for (FrameBlock frame; text.next(frame);) add(frame.positions, frame.scene.box, bins);
    }

    void add(const std::vector<Vec3>& positions, Vec3 box, std::size_t bins) {
        if (!(std::min({box.x, box.y, box.z}) > 0))
            throw FileError(fmt::format(
                "'{}' has no periodic box along all three axes, without which there is no density to compare "
                "distances with",
                shown(file_)));
        if (!distribution_) distribution_.emplace(box, bins);
        if (box != distribution_->box())
            throw FileError(fmt::format("the periodic box of '{}' changes from frame to frame", shown(file_)));
        distribution_->add(positions);
    }

    void write() const {
        if (!distribution_) throw FileError(fmt::format("'{}' holds no whole frame", shown(file_)));
        std::string text = "r,g\n";
        for (std::size_t bin = 0; bin < distribution_->bins(); ++bin)
            text +=
                fmt::format("{},{}\n", number_text(distribution_->distance(bin)), number_text((*distribution_)[bin]));
        OutputFile file(out_, compression_of(out_));
        file.write(text);
        file.commit();
    }

    std::string file_;
    bool rdf_ = false;
    std::string bins_ = "200";
    std::string out_ = "-";
    std::optional<RadialDistribution> distribution_;
};

}  // namespace

std::unique_ptr<Command> observe_command() { return std::make_unique<ObserveCommand>(); }

}  // namespace steplab
