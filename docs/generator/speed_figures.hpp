#pragma once

#include "plot/plot.hpp"
#include "results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace steplab::docs {

/// A diagram of results and its file in docs/images.
struct SpeedFigure {
    std::string file;
    plot::Plot figure;
};

/// Time per particle and step against the number of particles ("growing"), and the roofline ("roofline"; Williams,
/// Waterman, Patterson, Communications of the ACM 52 (2009) 65): springs per second against springs per byte that a
/// sweep reads or writes, below the limits set by the bandwidth of caches and memory and by square roots and divisions.
/// None where the results have no such rows.
std::vector<SpeedFigure> speed_figures(const Results& results);

/// The file name of the diagram "growing" or "roofline".
std::string speed_picture_name(const Results& results, std::string_view of);

/// "512 KiB".
std::string size_text(double bytes);

}  // namespace steplab::docs
