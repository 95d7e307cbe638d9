#include "io/trajectory_text.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/number_append.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace steplab {

namespace {

/// A line being built. The buffer is long enough for any: a number takes at most 24 characters.
class Line {
public:
    void clear() { end_ = text_; }
    void add(char c) { *end_++ = c; }
    void add(std::string_view word) {
        std::memcpy(end_, word.data(), word.size());
        end_ += word.size();
    }
    template <class Number>
    void add_number(Number value) {
        end_ = write_number(end_, value);
    }
    void add_vector(char separator, Vec3 v) {
        for (const double value : {v.x, v.y, v.z}) {
            add(separator);
            add_number(value);
        }
    }
    void append_to(std::string& text) const { text.append(text_, static_cast<std::size_t>(end_ - text_)); }

private:
    char text_[512];
    char* end_ = text_;
};

/// The numbers of a column in one frame of a block.
struct Source {
    const Vec3* rows;
    double Vec3::*component;
};

std::vector<Source> sources(const FrameBlock& block, std::size_t moment, const Columns& columns) {
    constexpr std::array<double Vec3::*, 3> components{&Vec3::x, &Vec3::y, &Vec3::z};
    const std::array<const std::vector<Vec3>*, 3> vectors{&block.positions, &block.velocities, &block.displacements};
    std::vector<Source> all;
    for (const Column column : columns) {
        const auto number = static_cast<std::size_t>(column);
        all.push_back({vectors[number / 3]->data() + moment * block.rows, components[number % 3]});
    }
    return all;
}

/// Appends a line for each row of one frame: `begin(line, row)` adds what precedes the numbers of the columns,
/// `end(line, row)` what follows them.
template <class Number, class Begin, class End>
void append_rows(std::string& text, const FrameBlock& block, std::size_t moment, const Columns& columns, char separator,
                 const Begin& begin, const End& end) {
    const std::vector<Source> numbers = sources(block, moment, columns);
    Line line;
    for (std::size_t row = 0; row < block.rows; ++row) {
        line.clear();
        begin(line, row);
        for (const Source& source : numbers) {
            line.add(separator);
            line.add_number(static_cast<Number>(source.rows[row].*source.component));
        }
        end(line, row);
        line.add('\n');
        line.append_to(text);
    }
}

template <class Begin, class End>
void append_rows(std::string& text, const FrameBlock& block, std::size_t moment, const Columns& columns, char separator,
                 const Begin& begin, const End& end) {
    if (block.scene.precision == Precision::float_) {
        append_rows<float>(text, block, moment, columns, separator, begin, end);
    } else {
        append_rows<double>(text, block, moment, columns, separator, begin, end);
    }
}

constexpr std::array position{Column::x, Column::y, Column::z};
constexpr std::array velocity{Column::vx, Column::vy, Column::vz};
constexpr std::array displacement{Column::ux, Column::uy, Column::uz};

bool any_of(const std::array<Column, 3>& vector, const Columns& columns) {
    return std::any_of(vector.begin(), vector.end(), [&](Column column) { return contains(columns, column); });
}

/// The columns of a frame in the order in which XYZ has them.
struct XyzColumns {
    Columns numbers;  ///< behind the species
    bool masses, momenta, roles;
    std::vector<const ParticleValues*> values = {};  ///< at the end of a line

    XyzColumns(const FrameBlock& block, const Columns& wanted)
        : numbers(position.begin(), position.end()),
          masses(block.scene.mass > 0 || !block.masses.empty()),
          momenta(masses && any_of(velocity, wanted)),
          roles(!block.roles.empty()) {
        const auto can_be_named = [](const ParticleValues& column) {
            return column.name.find_first_of(":=\"") == std::string::npos;
        };
        for (const ParticleValues& column : block.values) {
            if (can_be_named(column)) values.push_back(&column);
        }
        for (const auto& vector : {velocity, displacement}) {
            if (any_of(vector, wanted)) numbers.insert(numbers.end(), vector.begin(), vector.end());
        }
    }
    std::string properties() const {
        std::string text = "species:S:1:pos:R:3";
        if (any_of(velocity, numbers)) text += ":velo:R:3";
        if (any_of(displacement, numbers)) text += ":disp:R:3";
        if (momenta) text += ":momenta:R:3";
        if (masses) text += ":masses:R:1";
        if (roles) text += ":role:S:1";
        for (const ParticleValues* const column : values) text += ':' + column->name + ":R:1";
        return text;
    }
};

std::string cell_text(const Cell& cell) {
    std::string edges;
    for (const Vec3 edge : cell.edges)
        edges += fmt::format("{}{} {} {}", edges.empty() ? "" : " ", number_text(edge.x), number_text(edge.y),
                             number_text(edge.z));
    const auto flag = [&](std::size_t edge) { return cell.periodic[edge] ? 'T' : 'F'; };
    return fmt::format("Lattice=\"{}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\"", edges, number_text(cell.corner.x),
                       number_text(cell.corner.y), number_text(cell.corner.z), flag(0), flag(1), flag(2));
}

/// The periodic box, or that there is none, in the words of extended XYZ.
std::string box_text(const FileScene& scene) {
    if (scene.cell) return cell_text(*scene.cell);
    const Vec3 &box = scene.box, &corner = scene.corner;
    const auto flag = [](double side) { return side == 0 ? 'F' : 'T'; };
    std::string pbc = fmt::format("pbc=\"{} {} {}\"", flag(box.x), flag(box.y), flag(box.z));
    if (box == Vec3{}) return pbc;
    return fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" {}", number_text(box.x),
                       number_text(box.y), number_text(box.z), number_text(corner.x), number_text(corner.y),
                       number_text(corner.z), pbc);
}

}  // namespace

std::string csv_header(const Columns& columns) { return "step,time,particle," + names_of(columns) + "\n"; }

void append_csv(std::string& text, const FrameBlock& block, const Columns& columns, std::string_view begin) {
    for (std::size_t i = 0; i < block.moments.size(); ++i) {
        const std::string moment =
            fmt::format("{}{},{},", begin, block.moments[i].step, number_text(block.moments[i].time));
        const auto begin_line = [&](Line& line, std::size_t row) {
            line.add(moment);
            line.add_number(block.particle(row));
        };
        append_rows(text, block, i, columns, ',', begin_line, [](Line&, std::size_t) {});
    }
}

void check_xyz_columns(const Columns& columns) {
    for (const auto& vector : {position, velocity, displacement}) {
        const bool all =
            std::all_of(vector.begin(), vector.end(), [&](Column column) { return contains(columns, column); });
        if (all || (vector != position && !any_of(vector, columns))) continue;
        throw UsageError(
            fmt::format("XYZ holds whole vectors, the position always: --columns must name all of {} (got \"{}\")",
                        names_of(Columns(vector.begin(), vector.end())), names_of(columns)));
    }
}

void append_xyz(std::string& text, const FrameBlock& block, const Columns& columns) {
    const XyzColumns kept(block, columns);
    const auto mass = [&](std::size_t row) { return block.masses.empty() ? block.scene.mass : block.masses[row]; };
    for (std::size_t i = 0; i < block.moments.size(); ++i) {
        if (block.first_row == 0) {
            text += fmt::format("{}\n{} Properties={} Time={} Step={} Precision={}\n", block.frame_rows,
                                box_text(block.scene), kept.properties(), number_text(block.moments[i].time),
                                block.moments[i].step, id(block.scene.precision));
        }
        const auto end_line = [&](Line& line, std::size_t row) {
            if (kept.momenta) line.add_vector(' ', mass(row) * block.velocities[i * block.rows + row]);
            if (kept.masses) line.add(' '), line.add_number(mass(row));
            if (kept.roles) line.add(' '), line.add(id(block.roles[row]));
            if (kept.values.empty()) return;
            line.append_to(text);
            line.clear();
            for (const ParticleValues* const column : kept.values)
                text += ' ', append_number(text, column->values[row]);
        };
        append_rows(
            text, block, i, kept.numbers, ' ', [](Line& line, std::size_t) { line.add('X'); }, end_line);
    }
}

}  // namespace steplab
