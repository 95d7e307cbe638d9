#include "io/vtk_series.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/number_append.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <system_error>

namespace steplab {

namespace {

constexpr const char* head_of_file =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\">\n";

template <class Each>
void append_array(std::string& text, std::string_view attributes, std::size_t count, const Each& each) {
    text += fmt::format("<DataArray {} format=\"ascii\">\n", attributes);
    for (std::size_t i = 0; i < count; ++i) {
        each(i);
        text += '\n';
    }
    text += "</DataArray>\n";
}

void append_vectors(std::string& text, std::string_view name, const std::vector<Vec3>& vectors) {
    if (vectors.empty()) return;
    const auto attributes = fmt::format("type=\"Float64\" Name=\"{}\" NumberOfComponents=\"3\"", name);
    append_array(text, attributes, vectors.size(), [&](std::size_t i) {
        append_number(text, vectors[i].x);
        text += ' ';
        append_number(text, vectors[i].y);
        text += ' ';
        append_number(text, vectors[i].z);
    });
}

/// As an attribute of XML has it.
std::string escaped(std::string_view name) {
    std::string text;
    for (const char c : name) {
        switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '"':
                text += "&quot;";
                break;
            default:
                text += c;
        }
    }
    return text;
}

/// All but the positions.
void append_point_data(std::string& text, const FrameBlock& frame) {
    text += "<PointData>\n";
    append_array(text, "type=\"Int64\" Name=\"particle\"", frame.rows,
                 [&](std::size_t i) { append_number(text, static_cast<std::uint64_t>(frame.particle(i))); });
    append_vectors(text, "velocity", frame.velocities);
    append_vectors(text, "displacement", frame.displacements);
    if (!frame.masses.empty())
        append_array(text, "type=\"Float64\" Name=\"mass\"", frame.rows,
                     [&](std::size_t i) { append_number(text, frame.masses[i]); });
    if (!frame.roles.empty())
        append_array(text, "type=\"UInt8\" Name=\"role\"", frame.rows,
                     [&](std::size_t i) { append_number(text, static_cast<int>(frame.roles[i])); });
    if (!frame.types.empty())
        append_array(text, "type=\"UInt64\" Name=\"type\"", frame.rows,
                     [&](std::size_t i) { append_number(text, frame.types[i]); });
    for (const ParticleValues& column : frame.values)
        append_array(text, fmt::format("type=\"Float64\" Name=\"{}\"", escaped(column.name)), frame.rows,
                     [&](std::size_t i) { append_number(text, column.values[i]); });
    text += "</PointData>\n";
}

/// The springs between particles that are where they are shown, not at the place of an image.
std::vector<Spring> lines_of(const FrameBlock& frame, const Shape& shape) {
    std::vector<Spring> lines;
    for (const Spring& spring : shape.springs) {
        const Vec3 way = frame.positions[spring.second] - frame.positions[spring.first];
        if (shape.nearest(way) == way) lines.push_back(spring);
    }
    return lines;
}

void append_cells(std::string& text, std::string_view name, std::size_t count, std::size_t ends, const auto& each) {
    if (count == 0) return;
    text += fmt::format("<{}>\n", name);
    append_array(text, "type=\"Int64\" Name=\"connectivity\"", count, each);
    append_array(text, "type=\"Int64\" Name=\"offsets\"", count,
                 [&](std::size_t i) { append_number(text, static_cast<std::uint64_t>(ends * (i + 1))); });
    text += fmt::format("</{}>\n", name);
}

void write_whole(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path.string());
    file.write(text);
    file.commit();
}

}  // namespace

std::string vtp_text(const FrameBlock& frame, const Shape& shape) {
    const std::vector<Spring> lines = lines_of(frame, shape);
    std::string text = fmt::format(fmt::runtime(head_of_file), "PolyData");
    text += fmt::format(
        "<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">\n");
    append_number(text, frame.moments.front().time);
    text += fmt::format("\n</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\"{1}>\n",
                        frame.rows, lines.empty() ? "" : fmt::format(" NumberOfLines=\"{}\"", lines.size()));
    append_point_data(text, frame);
    text += "<Points>\n";
    append_vectors(text, "position", frame.positions);
    text += "</Points>\n";
    append_cells(text, "Verts", frame.rows, 1,
                 [&](std::size_t i) { append_number(text, static_cast<std::uint64_t>(i)); });
    append_cells(text, "Lines", lines.size(), 2, [&](std::size_t i) {
        append_number(text, lines[i].first);
        text += ' ';
        append_number(text, lines[i].second);
    });
    return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

VtkSeries::VtkSeries(const std::string& pvd) : pvd_(pvd), folder_(std::filesystem::path(pvd).replace_extension()) {
    std::error_code error;
    std::filesystem::create_directory(folder_, error);
    if (error || !std::filesystem::is_directory(folder_))
        throw FileError(fmt::format("cannot make the folder '{}' for the frames: {}", shown(folder_.string()),
                                    error ? error.message() : "something else has this name"));
}

void VtkSeries::add(const FrameBlock& frame) {
    write_whole(folder_ / fmt::format("{:06}.vtp", times_.size()), vtp_text(frame, shape_));
    times_.push_back(frame.moments.front().time);
}

void VtkSeries::finish() {
    std::string text = fmt::format(fmt::runtime(head_of_file), "Collection") + "<Collection>\n";
    for (std::size_t i = 0; i < times_.size(); ++i) {
        text += "<DataSet timestep=\"";
        append_number(text, times_[i]);
        text += fmt::format("\" part=\"0\" file=\"{}/{:06}.vtp\"/>\n", escaped(folder_.filename().string()), i);
    }
    write_whole(pvd_, text + "</Collection>\n</VTKFile>\n");
}

}  // namespace steplab
