#include "app/commands/export.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/lammps_options.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/text.hpp"
#include "io/compression.hpp"
#include "io/lammps/lammps_output.hpp"
#include "io/output_file.hpp"
#include "io/scene_export.hpp"
#include "io/trajectory.hpp"
#include "sim/run/simulation.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace steplab {

namespace {

constexpr std::string_view to_scene = "scene", to_lammps = "lammps", to_xyz = "xyz";
constexpr std::array formats{to_scene, to_lammps, to_xyz};

class ExportCommand final : public Command {
public:
    std::string_view name() const override { return "export"; }
    std::string_view what() const override { return "Write a scene as a file, as XYZ, or as input of LAMMPS"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        lammps_.declare(app);
        text_option(app, "--to", to_, "scene|lammps|xyz",
                    "Kind of file: scene, TOML for --scene; files for LAMMPS; or its particles as XYZ");
        text_option(app, "--out", out_, "FILE|DIR|-", "Output file (default -, standard output); with lammps a folder");
        app_ = &app;
    }

    int run() override {
        if (to_.empty()) throw UsageError("--to is required: --to scene, --to lammps or --to xyz");
        if (std::find(formats.begin(), formats.end(), to_) == formats.end())
            throw UsageError(unknown_word("kind of file", to_, formats));
        if (to_ != to_lammps) refuse_time();
        if (to_ == to_scene) write_scene(out_, scene_.description());
        if (to_ == to_xyz) write_start();
        if (to_ == to_lammps) write_lammps_files();
        return static_cast<int>(ExitCode::done);
    }

private:
    void refuse_time() const {
        for (const char* option : {"--steps", "--until", "--every"}) {
            if (is_given(*app_, option)) throw UsageError(std::string(option) + " belongs to --to lammps");
        }
    }

    /// The particles at the start.
    void write_start() const {
        const RunDescription run = scene_.description();
        const Simulation simulation(run);
        OutputFile file(out_, compression_of(out_));
        TrajectoryWriter writer(file, TrajectoryFormat::xyz, run);
        Frame frame;
        simulation.frame(frame, writer.needs());
        writer.add(frame);
        writer.finish();
        file.commit();
    }

    void write_lammps_files() const {
        if (out_ == "-") throw UsageError("--to lammps needs --out DIR, a folder for its files");
        const RunDescription run = lammps_method_checked(scene_);
        if (run.dt < 0) throw UsageError("LAMMPS goes forward in time: dt must be > 0");
        const LammpsTime time = lammps_.time(time_.end(run).step);
        catch_interruptions();
        refuse_results(out_);
        print(export_text(export_to_lammps(run, time, out_), out_));
    }

    SceneOptions scene_{SceneOptions::Time::both};
    TimeOptions time_{1000, TimeOptions::Default::scene};
    LammpsOptions lammps_;
    std::string to_;
    std::string out_ = "-";
    const CLI::App* app_ = nullptr;
};

}  // namespace

std::unique_ptr<Command> export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace steplab
