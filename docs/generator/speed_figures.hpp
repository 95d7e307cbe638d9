#pragma once

#include "lab/report/figure.hpp"
#include "results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace steplab::docs {

/// A diagram of results and its file in docs/images.
struct SpeedFigure {
    std::string file;
    Figure figure;
};

/// How the time of a step grows with the number of particles ("growing"), and the roofline ("roofline"; Williams,
/// Waterman, Patterson, Communications of the ACM 52 (2009) 65): springs a second over springs for each byte that a
/// sweep reads or writes, below what the caches, the memory and the units for roots and quotients allow. None where
/// the results have no such rows.
std::vector<SpeedFigure> speed_figures(const Results& results);

/// The file of one of them.
std::string speed_picture_name(const Results& results, std::string_view of);

/// "512 KB".
std::string size_text(double bytes);

}  // namespace steplab::docs
