#pragma once

#include "core/diagnostics.hpp"
#include "io/output_file.hpp"

#include <cstdint>

namespace steplab {

/// Writes the diagnostics of a run over time as CSV, one line a moment:
/// step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,max_displacement,max_speed and, where the exact
/// solution is known, error.
class SeriesWriter {
public:
    /// `file` must outlive the writer.
    SeriesWriter(OutputFile& file, bool with_error);
    void add(std::uint64_t step, double time, const Diagnostics& diagnostics);

private:
    OutputFile& file_;
    bool with_error_;
};

}  // namespace steplab
