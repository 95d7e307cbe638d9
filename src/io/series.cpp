#include "io/series.hpp"

#include "io/number_append.hpp"

namespace steplab {

SeriesWriter::SeriesWriter(OutputFile& file, bool with_error, bool with_run)
    : file_(file), with_error_(with_error), with_run_(with_run) {
    if (with_run) file_.write("run,");
    file_.write(
        "step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,"
        "max_displacement,max_speed");
    file_.write(with_error_ ? ",error\n" : "\n");
}

void SeriesWriter::add(std::uint64_t step, double time, const Diagnostics& d, std::size_t run) {
    std::string line;
    if (with_run_) {
        append_number(line, run);
        line += ',';
    }
    append_number(line, step);
    const auto append = [&line](double value) {
        line += ',';
        append_number(line, value);
    };
    for (const double value : {time, d.kinetic, d.potential, d.energy, d.energy_error}) append(value);
    for (const Vec3& v : {d.momentum, d.angular_momentum}) {
        for (const double value : {v.x, v.y, v.z}) append(value);
    }
    append(d.max_displacement);
    append(d.max_speed);
    if (with_error_ && d.error) append(*d.error);
    if (with_error_ && !d.error) line += ',';  // no longer known: an empty cell
    line += '\n';
    file_.write(line);
}

}  // namespace steplab
