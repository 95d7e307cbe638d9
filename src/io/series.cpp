#include "io/series.hpp"

#include "io/number_append.hpp"

#include <utility>

namespace steplab {

SeriesWriter::SeriesWriter(OutputFile& file, Columns columns) : file_(file), columns_(std::move(columns)) {
    file_.at_program_end(UnfinishedFile::AtEnd::kept_in_lines);
    if (columns_.run) file_.write("run,");
    file_.write(
        "step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,"
        "max_displacement,max_speed");
    std::string rest = columns_.error ? ",error" : "";
    for (const std::string& name : columns_.more) rest += ',' + name;
    file_.write(rest + '\n');
}

void SeriesWriter::add(std::uint64_t step, double time, const Diagnostics& d, std::size_t run,
                       std::span<const std::optional<double>> more) {
    std::string line;
    if (columns_.run) {
        append_number(line, run);
        line += ',';
    }
    append_number(line, step);
    const auto append = [&line](double value) {
        line += ',';
        append_number(line, value);
    };
    for (const double value : {time, d.kinetic, d.potential, d.energy}) append(value);
    if (columns_.energy_error)
        append(d.energy_error);
    else
        line += ',';
    for (const Vec3& v : {d.momentum, d.angular_momentum}) {
        for (const double value : {v.x, v.y, v.z}) append(value);
    }
    append(d.max_displacement);
    append(d.max_speed);
    if (columns_.error && d.error) append(*d.error);
    if (columns_.error && !d.error) line += ',';  // no longer known: an empty cell
    for (const std::optional<double>& value : more) {
        line += ',';
        if (value) append_number(line, *value);
    }
    line += '\n';
    file_.write(line);
}

}  // namespace steplab
