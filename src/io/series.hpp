#pragma once

#include "core/diagnostics.hpp"
#include "io/output_file.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// Writes the diagnostics of a run over time as CSV, one line per sample:
/// step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,max_displacement,max_speed and, where the exact
/// solution is known, error; then further columns.
class SeriesWriter {
public:
    struct Columns {
        bool error = false;                  ///< against the exact solution
        bool energy_error = true;            ///< else its cells are empty: with drag, E - E0 is no error
        bool run = false;                    ///< every line begins with the number of the run
        std::vector<std::string> more = {};  ///< names of further columns, at the end
    };

    /// `file` must outlive the writer.
    SeriesWriter(OutputFile& file, Columns columns);
    /// `more`: the values of the further columns; an empty cell for none.
    void add(std::uint64_t step, double time, const Diagnostics& diagnostics, std::size_t run = 0,
             std::span<const std::optional<double>> more = {});

private:
    OutputFile& file_;
    Columns columns_;
};

}  // namespace steplab
