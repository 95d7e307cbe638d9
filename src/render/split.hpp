#pragma once

#include "render/camera.hpp"
#include "render/style.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace steplab::render {

/// A part of a picture, in pixels from its top left corner.
struct PictureArea {
    int left = 0;
    int top = 0;
    PictureSize size;
    friend bool operator==(const PictureArea&, const PictureArea&) = default;
};

/// The areas of runs that have a part of a picture each: two beside each other, or one above the other where the
/// picture is higher than wide; three and four in two rows. They cover the picture, but for the last quarter of three.
std::vector<PictureArea> split_areas(PictureSize picture, std::size_t runs);

/// The areas of a picture of so many runs: all of it where they are drawn in one view.
std::vector<PictureArea> areas_of(PictureSize picture, RunLayout layout, std::size_t runs);

/// The part of a picture that the camera is for: that of the leading run.
inline PictureSize leading_size(PictureSize picture, RunLayout layout, std::size_t runs) {
    return areas_of(picture, layout, runs).front().size;
}

/// The part that two areas share; none if they share none.
std::optional<PictureArea> shared_part(const PictureArea& a, const PictureArea& b);

}  // namespace steplab::render
