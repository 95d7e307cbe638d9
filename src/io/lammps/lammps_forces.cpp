#include "io/lammps/lammps_forces.hpp"

#include "core/error.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/lammps/lammps_table.hpp"
#include "io/output_file.hpp"
#include "models/scene/composer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

using Way = LammpsPairForce::Way;

/// One of 10 MB for each pair of types.
constexpr std::size_t most_tables = 50;

std::string table_name(std::size_t force, std::size_t one, std::size_t other) {
    return fmt::format("FORCE_{}_{}_{}", force + 1, one + 1, other + 1);
}

}  // namespace

LammpsForces::LammpsForces(const LammpsScene& scene) : scene_(scene) { make_tables(); }
LammpsForces::~LammpsForces() = default;

bool LammpsForces::act(std::size_t force, std::size_t one, std::size_t other) const {
    const LammpsType &a = scene_.types()[one], &b = scene_.types()[other];
    return LammpsPairForce::acts(a, b, force) || LammpsPairForce::acts(b, a, force);
}

/// One force between all particles.
bool LammpsForces::is_plain() const {
    if (scene_.pair_forces().size() != 1) return false;
    for (std::size_t one = 0; one < scene_.types().size(); ++one) {
        for (std::size_t other = one; other < scene_.types().size(); ++other) {
            if (!act(0, one, other)) return false;
        }
    }
    return true;
}

double LammpsForces::cutoff(const LammpsPairForce& force) const {
    return force.cutoff > 0 ? force.cutoff : scene_.reach();
}

void LammpsForces::make_tables() {
    const auto& types = scene_.types();
    for (std::size_t force = 0; force < scene_.pair_forces().size(); ++force) {
        const LammpsPairForce& of = scene_.pair_forces()[force];
        if (of.way != Way::table) continue;
        const ComposedPairs composed = pair_force_of(*of.term, 1);
        for (std::size_t one = 0; one < types.size(); ++one) {
            for (std::size_t other = one; other < types.size(); ++other) {
                if (!act(force, one, other)) continue;
                const bool in_order = LammpsPairForce::acts(types[one], types[other], force);
                const LammpsType &a = types[in_order ? one : other], &b = types[in_order ? other : one];
                tables_.push_back({force, one, other});
                contents_.emplace_back(composed, PairProperties<double>{a.mass, b.mass, a.charge, b.charge},
                                       scene_.nearest(), cutoff(of));
                if (tables_.size() > most_tables)
                    throw UsageError(fmt::format(
                        "the scene cannot be expressed in LAMMPS: its pair forces would need more than {} tables, "
                        "for particles of different mass, charge or group",
                        most_tables));
            }
        }
    }
    if (tables_.empty()) return;
    const LammpsTableSize size = size_for(contents_);
    table_error_ = size.error;
    table_style_ = size.kind == LammpsTable::Kind::bitmap ? fmt::format("table bitmap {}", size.bits)
                                                          : fmt::format("table spline {}", 1 << size.bits);
}

double LammpsForces::neighbour_force() const {
    double largest = 0;
    for (const LammpsTable& table : contents_) largest = std::max(largest, table.neighbour_force());
    return largest;
}

double LammpsForces::neighbour_acceleration() const {
    double largest = 0;
    for (std::size_t i = 0; i < contents_.size(); ++i) {
        for (const std::size_t type : {tables_[i].one, tables_[i].other}) {
            const LammpsType& of = scene_.types()[type];
            if (!of.fixed) largest = std::max(largest, contents_[i].neighbour_force() / of.mass);
        }
    }
    return largest;
}

std::string LammpsForces::style_name(std::size_t force) const {
    const LammpsPairForce& of = scene_.pair_forces()[force];
    const bool cut = of.cutoff > 0;
    switch (of.way) {
        case Way::lennard_jones:
            return cut ? "lj/smooth/linear" : "lj/cut";
        case Way::morse:
            return cut ? "morse/smooth/linear" : "morse";
        case Way::charges:
            return "coul/cut";
        case Way::table:
            break;
    }
    return "table";
}

std::string LammpsForces::style(std::size_t force) const {
    const LammpsPairForce& of = scene_.pair_forces()[force];
    return of.way == Way::table ? table_style_ : fmt::format("{} {}", style_name(force), cutoff(of));
}

/// " 2" for the second of one style: each force has its own.
std::string LammpsForces::number_of(std::size_t force) const {
    std::size_t before = 0, all = 0;
    for (std::size_t other = 0; other < scene_.pair_forces().size(); ++other) {
        if (style_name(other) != style_name(force)) continue;
        ++all;
        if (other < force) ++before;
    }
    return all > 1 ? fmt::format(" {}", before + 1) : "";
}

std::string LammpsForces::coefficients(std::size_t force, std::size_t one, std::size_t other) const {
    const LammpsPairForce& of = scene_.pair_forces()[force];
    switch (of.way) {
        case Way::lennard_jones:
            return fmt::format(" {} {}", of.value("epsilon"), of.value("sigma"));
        case Way::morse:
            return fmt::format(" {} {} {}", of.value("D"), std::sqrt(of.value("k") / (2 * of.value("D"))),
                               of.value("r0"));
        case Way::charges:
            return "";
        case Way::table:
            break;
    }
    return fmt::format(" {} {} {}", lammps_files::tables, table_name(force, one, other), cutoff(of));
}

std::string LammpsForces::plain_lines() const {
    std::string text = fmt::format("pair_style {}\n", style(0));
    if (tables_.empty()) text += fmt::format("pair_coeff * *{}\n", coefficients(0, 0, 0));
    for (const Table& table : tables_)
        text += fmt::format("pair_coeff {} {}{}\n", table.one + 1, table.other + 1,
                            coefficients(0, table.one, table.other));
    return text;
}

std::string LammpsForces::overlaid_lines() const {
    std::string text = "pair_style hybrid/overlay";
    for (std::size_t force = 0; force < scene_.pair_forces().size(); ++force) text += fmt::format(" {}", style(force));
    text += '\n';
    for (std::size_t one = 0; one < scene_.types().size(); ++one) {
        for (std::size_t other = one; other < scene_.types().size(); ++other) {
            bool any = false;
            for (std::size_t force = 0; force < scene_.pair_forces().size(); ++force) {
                if (!act(force, one, other)) continue;
                text += fmt::format("pair_coeff {} {} {}{}{}\n", one + 1, other + 1, style_name(force),
                                    number_of(force), coefficients(force, one, other));
                any = true;
            }
            if (!any)
                text += fmt::format("pair_coeff {0} {1} none\nneigh_modify exclude type {0} {1}\n", one + 1, other + 1);
        }
    }
    return text;
}

std::string LammpsForces::lines() const {
    if (scene_.pair_forces().empty()) return {};
    return is_plain() ? plain_lines() : overlaid_lines();
}

void LammpsForces::write_tables(const std::string& name) const {
    if (tables_.empty()) return;
    OutputFile file(name);
    file.write(fmt::format("# forces by table for pair_style {}, by steplab\n\n", table_style_));
    for (std::size_t i = 0; i < tables_.size(); ++i)
        contents_[i].write(file, table_name(tables_[i].force, tables_[i].one, tables_[i].other));
    file.commit();
}

}  // namespace steplab
