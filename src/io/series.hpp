#pragma once

#include "core/diagnostics.hpp"
#include "io/output_file.hpp"

#include <cstddef>
#include <cstdint>

namespace steplab {

/// Writes the diagnostics of a run over time as CSV, one line per sample:
/// step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,max_displacement,max_speed and, where the exact
/// solution is known, error.
class SeriesWriter {
public:
    /// `file` must outlive the writer. `with_run`: every line begins with the number of the run.
    SeriesWriter(OutputFile& file, bool with_error, bool with_run = false);
    void add(std::uint64_t step, double time, const Diagnostics& diagnostics, std::size_t run = 0);

private:
    OutputFile& file_;
    bool with_error_;
    bool with_run_;
};

}  // namespace steplab
