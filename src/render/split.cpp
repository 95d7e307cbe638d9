#include "render/split.hpp"

#include <algorithm>

namespace steplab::render {
namespace {

/// A length in one or two parts.
struct Part {
    int begin, length;
};
std::vector<Part> parts_of(int length, bool halved) {
    if (!halved || length < 2) return std::vector<Part>(halved ? 2 : 1, {0, length});
    const int half = length / 2;
    return {{0, half}, {half, length - half}};
}

}  // namespace

std::vector<PictureArea> split_areas(PictureSize picture, std::size_t runs) {
    const bool wide = picture.width >= picture.height;
    std::vector<PictureArea> areas;
    for (const Part& row : parts_of(picture.height, runs > 2 || (runs == 2 && !wide))) {
        for (const Part& column : parts_of(picture.width, runs > 2 || (runs == 2 && wide)))
            areas.push_back({column.begin, row.begin, {column.length, row.length}});
    }
    areas.resize(std::clamp<std::size_t>(runs, 1, areas.size()));
    return areas;
}

std::vector<PictureArea> areas_of(PictureSize picture, RunLayout layout, std::size_t runs) {
    return split_areas(picture, layout == RunLayout::split ? runs : 1);
}

std::optional<PictureArea> shared_part(const PictureArea& a, const PictureArea& b) {
    const int left = std::max(a.left, b.left), top = std::max(a.top, b.top);
    const int right = std::min(a.left + a.size.width, b.left + b.size.width);
    const int bottom = std::min(a.top + a.size.height, b.top + b.size.height);
    if (right <= left || bottom <= top) return std::nullopt;
    return PictureArea{left, top, {right - left, bottom - top}};
}

}  // namespace steplab::render
