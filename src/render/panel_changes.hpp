#pragma once

#include "render/split.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

struct ImDrawCmd;
struct ImDrawData;
struct ImDrawList;

namespace steplab::render {

/// Finds where draw data of Dear ImGui looks otherwise than the data before it, so that only that is drawn again. A
/// number is kept of each tile of the picture, made of the bytes of all triangles that touch it, in their order.
/// What a texture holds is not looked at.
class PanelChanges {
public:
    /// The changed areas, in pixels of the picture, no two of which share one; all of it for the first data, and where
    /// its size changed. What lies in `covered`, over which something else is drawn, is left out.
    std::vector<PictureArea> take(const ImDrawData& data, const PictureArea& covered);
    /// The next data is as the first.
    void forget() { seen_.clear(); }

private:
    static constexpr int side = 32;  ///< of a tile, in pixels

    void add_list(const ImDrawList& list, const ImDrawData& data);
    void add_command(const ImDrawList& list, const ImDrawCmd& command, const ImDrawData& data);
    void add(PixelPoint low, PixelPoint high, std::uint64_t triangle);
    std::vector<PictureArea> changed_areas() const;
    PictureArea tile(int column, int row) const;
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    PictureSize size_{0, 0};
    int columns_ = 0, rows_ = 0;
    std::vector<std::uint64_t> seen_, now_;  ///< of each tile, row by row
};

}  // namespace steplab::render
