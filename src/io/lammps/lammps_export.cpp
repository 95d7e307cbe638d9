#include "io/lammps/lammps_export.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/commit.hpp"
#include "io/lammps/lammps_bonds.hpp"
#include "io/lammps/lammps_data.hpp"
#include "io/lammps/lammps_forces.hpp"
#include "io/lammps/lammps_outside.hpp"
#include "io/lammps/lammps_scene.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace steplab {

namespace {

constexpr std::uint64_t lines_of_progress = 200;
constexpr std::size_t usual_neighbours = 2000;
constexpr double stretched = 3;
/// Particles of scenes up to this size may all be neighbours of one.
constexpr std::size_t few_particles = 20000;

/// A scene and the length of its run as an input script.
class Script {
public:
    Script(const RunDescription& run, const LammpsTime& time, const LammpsScene& scene, const LammpsForces& forces,
           const LammpsBonds& bonds)
        : run_(run), time_(time), scene_(scene), forces_(forces), bonds_(bonds) {}

    std::string text() const {
        const std::string outside = outside_lines(scene_);
        return head() + space() + "read_data scene.data\n\n" + bonds_.coefficient_lines() + forces_.lines() +
               neighbours() + groups() + outside + limit_of_distance() + output(outside) + motion();
    }
    bool is_unlimited() const {
        const auto& all = scene_.pair_forces();
        return std::any_of(all.begin(), all.end(), [](const auto& force) { return force.cutoff == 0; });
    }

private:
    /// Three double quotes begin a text of several lines, also in a comment.
    std::string title() const {
        std::string title = shown(model_of(run_).info.name);
        std::replace(title.begin(), title.end(), '"', '\'');
        return title;
    }

    std::string head() const {
        return fmt::format(
            "# {}: for LAMMPS, by steplab {}. Units are the scene's own; LAMMPS calls them lj.\n"
            "# -var steps N computes another number of steps.\n"
            "variable steps index {}\n\nunits lj\natom_style {}\n",
            title(), STEPLAB_VERSION, time_.steps, atom_style(scene_));
    }

    /// Without a period, the box grows with the particles.
    std::string space() const {
        const Vec3 box = scene_.box();
        const auto boundary = [](double side) { return side > 0 ? 'p' : 'm'; };
        std::string text = fmt::format("boundary {} {} {}\n", boundary(box.x), boundary(box.y), boundary(box.z));
        if (scene_.is_attractive())
            text += "dielectric -1  # equal charges, which are masses here, attract each other\n";
        return text + bonds_.style_lines();
    }

    std::string neighbours() const {
        const double cutoff = longest_cutoff(), bond = scene_.longest_bond();
        const double skin = is_unlimited() ? 0.002 * cutoff : cutoff > 0 ? 0.15 * cutoff : bond > 0 ? 0.5 * bond : 1;
        std::string text = fmt::format("\nneighbor {:.6g} {}\nneigh_modify delay 0 every 1 check yes", skin,
                                       is_unlimited() ? "nsq" : "bin");
        if (is_unlimited() || scene_.count() <= few_particles) {
            const std::size_t one = std::max(usual_neighbours, scene_.count());
            text += fmt::format(" one {} page {}", one, std::max<std::size_t>(100000, 10 * one));
        }
        text += '\n';
        if (bond > 0) text += fmt::format("atom_modify sort 1000 {:.6g}\n", std::max(bond, fewest_bins()));
        // A bond may stretch to three times its length; LAMMPS ends with a message where one is longer.
        const double halo = bond > 0 ? stretched * bond : 1;
        return text + (halo > cutoff + skin ? fmt::format("comm_modify cutoff {:.6g}\n", halo) : "");
    }
    /// The side of bins of which there are two for each particle in the whole box: a mesh is in a plane of it, and
    /// LAMMPS has an array of all.
    double fewest_bins() const {
        const Vec3 way = scene_.high() - scene_.low(), box = scene_.box();
        const auto side = [room = 0.2 * length(way)](double period, double along) {
            return period > 0 ? period : along + room;
        };
        const double volume = side(box.x, way.x) * side(box.y, way.y) * side(box.z, way.z);
        return std::cbrt(volume / (2 * static_cast<double>(scene_.count())));
    }
    double longest_cutoff() const {
        double longest = 0;
        for (const LammpsPairForce& force : scene_.pair_forces())
            longest = std::max(longest, force.cutoff > 0 ? force.cutoff : scene_.reach());
        return longest;
    }

    std::string groups() const {
        if (!scene_.has_fixed()) return "\ngroup moving union all\n";
        std::string text = "\ngroup fixed type";
        for (std::size_t i = 0; i < scene_.types().size(); ++i) {
            if (scene_.types()[i].fixed) text += fmt::format(" {}", i + 1);
        }
        text += "\ngroup moving subtract all fixed\n";
        return text + (scene_.pair_forces().empty() ? "" : "neigh_modify exclude group fixed fixed\n");
    }

    /// A force without cut-off has one here, beyond every distance; no pair may reach it.
    std::string limit_of_distance() const {
        if (!is_unlimited()) return {};
        std::string sum;
        for (const char axis : {'x', 'y', 'z'})
            sum += fmt::format("{}(bound(all,{}max)-bound(all,{}min))^2", sum.empty() ? "" : "+", axis, axis);
        return fmt::format(
            "\nvariable reach equal sqrt({})\nfix reach all halt 100 v_reach > {} error hard message yes\n", sum,
            scene_.reach());
    }

    /// Energies at every moment of the trajectory, and often enough to see how far the run is.
    std::uint64_t every_energy() const {
        const std::uint64_t every = moments();
        std::uint64_t divisor = std::clamp<std::uint64_t>(time_.steps / lines_of_progress, 1, every);
        while (every % divisor != 0) --divisor;
        return divisor;
    }
    std::uint64_t moments() const { return time_.every > 0 ? time_.every : std::max<std::uint64_t>(1, time_.steps); }

    /// `outside`: what acts from outside.
    std::string output(const std::string& outside) const {
        return fmt::format(
            "\ncompute kinetic all ke\nvariable outside equal {}\nthermo_style custom step pe c_kinetic v_outside\n"
            "thermo_modify norm no format float %.17g flush yes\nthermo {}\n"
            "dump moments all custom {} {} id type xu yu zu vx vy vz\n"
            "dump_modify moments sort id format float %.17g time yes\n",
            outside_energy(outside), every_energy(), moments(), lammps_files::trajectory);
    }

    std::string motion() const {
        std::string text = fmt::format("\nfix motion moving nve\ntimestep {}\nrun ${{steps}}\n", run_.dt);
        text += fmt::format(
            "if \"$(v_steps % {}) > 0\" then \"write_dump all custom {} id type xu yu zu vx vy vz modify sort id "
            "format "
            "float %.17g append yes time yes\"\n",
            moments(), lammps_files::trajectory);
        if (is_unlimited())
            text += fmt::format(
                "if \"$(v_reach) > {}\" then \"print 'ERROR: a distance is beyond the cut-off'\" "
                "\"quit 1\"\n",
                scene_.reach());
        return text;
    }

    const RunDescription& run_;
    const LammpsTime& time_;
    const LammpsScene& scene_;
    const LammpsForces& forces_;
    const LammpsBonds& bonds_;
};

/// Settings of Open MPI are given by its environment, which other implementations do not read.
std::string run_script() {
    return fmt::format(
        "#!/bin/sh\n# Computes the scene with LAMMPS: ./run.sh [RANKS [OPTION OF LAMMPS...]]\n"
        "cd -- \"$(dirname -- \"$0\")\" || exit 1\nranks=${{1:-1}}\n[ $# -eq 0 ] || shift\n"
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1\n"
        "export OMP_NUM_THREADS=\"${{OMP_NUM_THREADS:-1}}\"\n"
        "[ \"$ranks\" != 1 ] || exec \"${{LAMMPS:-lmp}}\" -in {0} -log {1} \"$@\"\n"
        "exec mpirun -np \"$ranks\" \"${{LAMMPS:-lmp}}\" -in {0} -log {1} \"$@\"\n",
        lammps_files::input, lammps_files::log);
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return;
    throw FileError(fmt::format("cannot make the folder '{}': {}", shown(folder), error.message()));
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path.string());
    file.write(text);
    file.commit();
}

}  // namespace

LammpsExport export_to_lammps(const RunDescription& run, const LammpsTime& time, const std::string& folder) {
    const LammpsScene scene(run);
    const LammpsForces forces(scene);
    const LammpsBonds bonds(scene);
    const Script script(run, time, scene, forces, bonds);
    const std::string input = script.text();
    make_folder(folder);
    const std::filesystem::path path(folder);
    write_lammps_data(scene, shown(model_of(run).info.name), (path / lammps_files::data).string());
    forces.write_tables((path / lammps_files::tables).string());
    bonds.write_tables((path / lammps_files::bond_tables).string());
    write_text(path / lammps_files::input, input);
    write_text(path / lammps_files::script, run_script());
    std::error_code ignored;
    using std::filesystem::perms;
    std::filesystem::permissions(path / lammps_files::script,
                                 perms::owner_exec | perms::group_exec | perms::others_exec,
                                 std::filesystem::perm_options::add, ignored);
    LammpsExport result{.particles = scene.count(),
                        .bonds = scene.bonds(),
                        .table_error = std::max(forces.table_error(), bonds.table_error()),
                        .neighbour_force = std::max(forces.neighbour_force(), bonds.force()),
                        .neighbour_acceleration = std::max(forces.neighbour_acceleration(), bonds.acceleration())};
    if (script.is_unlimited()) result.reach = scene.reach();
    if (run.method != "velocity-verlet")
        result.notes.push_back(
            fmt::format("LAMMPS runs the scene by velocity Verlet (fix nve), not by {}", run.method));
    if (has_drag(run))
        result.notes.emplace_back("LAMMPS takes drag explicitly (fix viscous): its error is of first order");
    return result;
}

}  // namespace steplab
