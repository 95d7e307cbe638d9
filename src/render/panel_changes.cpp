#include "render/panel_changes.hpp"

#include "core/clamped.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

namespace steplab::render {
namespace {

/// Not one that is hard to break, but no two pictures of panels will have the same by chance.
std::uint64_t mixed(std::uint64_t number, std::uint64_t with) {
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U;
    const std::uint64_t product = (number ^ with) * odd;
    return product ^ (product >> 32U);
}

template <class T>
std::uint64_t mixed_bytes(std::uint64_t number, const T& value) {
    std::array<std::uint32_t, sizeof(T) / sizeof(std::uint32_t)> words{};
    static_assert(sizeof(words) == sizeof(T));
    std::memcpy(words.data(), &value, sizeof(T));
    for (const std::uint32_t word : words) number = mixed(number, word);
    return number;
}

double pixel(float at, float origin, float scale) {
    return static_cast<double>(at - origin) * static_cast<double>(scale);
}

/// The parts of an area above, below and beside another one.
void add_outside(std::vector<PictureArea>& areas, const PictureArea& area, const PictureArea& other) {
    const auto shared = shared_part(area, other);
    if (!shared) return areas.push_back(area);
    const auto add = [&](int left, int top, int right, int bottom) {
        if (right > left && bottom > top) areas.push_back({left, top, {right - left, bottom - top}});
    };
    const int right = area.left + area.size.width, bottom = area.top + area.size.height;
    const int inner_right = shared->left + shared->size.width, inner_bottom = shared->top + shared->size.height;
    add(area.left, area.top, right, shared->top);
    add(area.left, inner_bottom, right, bottom);
    add(area.left, shared->top, shared->left, inner_bottom);
    add(inner_right, shared->top, right, inner_bottom);
}

PictureArea hull(const PictureArea& a, const PictureArea& b) {
    const int left = std::min(a.left, b.left), top = std::min(a.top, b.top);
    const int right = std::max(a.left + a.size.width, b.left + b.size.width);
    const int bottom = std::max(a.top + a.size.height, b.top + b.size.height);
    return {left, top, {right - left, bottom - top}};
}

}  // namespace

std::vector<PictureArea> PanelChanges::take(const ImDrawData& data, const PictureArea& covered) {
    const PictureSize size{static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x),
                           static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y)};
    if (std::exchange(size_, size) != size) forget();
    columns_ = (size.width + side - 1) / side;
    rows_ = (size.height + side - 1) / side;
    now_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (int i = 0; i < data.CmdListsCount; ++i) add_list(*data.CmdLists[i], data);
    std::vector<PictureArea> areas;
    for (const PictureArea& area : changed_areas()) add_outside(areas, area, covered);
    seen_.swap(now_);
    return areas;
}

void PanelChanges::add_list(const ImDrawList& list, const ImDrawData& data) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (!command.UserCallback) add_command(list, command, data);
    }
}

void PanelChanges::add_command(const ImDrawList& list, const ImDrawCmd& command, const ImDrawData& data) {
    const std::uint64_t begin = mixed_bytes(mixed_bytes(1, command.ClipRect), command.GetTexID());
    const ImVec4& clip = command.ClipRect;
    const ImVec2 origin = data.DisplayPos, scale = data.FramebufferScale;
    const ImDrawIdx* const indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        const ImDrawVert &a = vertices[indices[i]], &b = vertices[indices[i + 1]], &c = vertices[indices[i + 2]];
        const double left = pixel(std::max(clip.x, std::min({a.pos.x, b.pos.x, c.pos.x})), origin.x, scale.x);
        const double top = pixel(std::max(clip.y, std::min({a.pos.y, b.pos.y, c.pos.y})), origin.y, scale.y);
        const double right = pixel(std::min(clip.z, std::max({a.pos.x, b.pos.x, c.pos.x})), origin.x, scale.x);
        const double bottom = pixel(std::min(clip.w, std::max({a.pos.y, b.pos.y, c.pos.y})), origin.y, scale.y);
        if (!(left <= right && top <= bottom)) continue;
        add({left, top}, {right, bottom}, mixed_bytes(mixed_bytes(mixed_bytes(begin, a), b), c));
    }
}

/// To the tiles that a triangle may touch.
void PanelChanges::add(PixelPoint low, PixelPoint high, std::uint64_t triangle) {
    constexpr double margin = 1;
    const auto first = [](double at, int count) { return clamped_floor((at - margin) / side, 0, count); };
    const auto last = [](double at, int count) { return clamped_floor((at + margin) / side, -1, count - 1); };
    const int last_column = last(high.x, columns_), last_row = last(high.y, rows_);
    for (int row = first(low.y, rows_); row <= last_row; ++row) {
        for (int column = first(low.x, columns_); column <= last_column; ++column) {
            std::uint64_t& tile = now_[number(column, row)];
            tile = mixed(tile, triangle);
        }
    }
}

PictureArea PanelChanges::tile(int column, int row) const {
    const int left = column * side, top = row * side;
    return {left, top, {std::min(side, size_.width - left), std::min(side, size_.height - top)}};
}

/// Neighbours in a row are one area, and such areas below each other if they are equally wide.
std::vector<PictureArea> PanelChanges::changed_areas() const {
    std::vector<PictureArea> areas;
    for (int row = 0; row < rows_; ++row) {
        std::vector<PictureArea> in_row;
        bool open = false;
        for (int column = 0; column < columns_; ++column) {
            const std::size_t place = number(column, row);
            const PictureArea here = tile(column, row);
            const bool changed = seen_.empty() || seen_[place] != now_[place];
            if (changed && open) {
                in_row.back() = hull(in_row.back(), here);
            } else if (changed) {
                in_row.push_back(here);
            }
            open = changed;
        }
        for (const PictureArea& area : in_row) {
            const auto above = std::find_if(areas.begin(), areas.end(), [&](const PictureArea& other) {
                return other.left == area.left && other.size.width == area.size.width &&
                       other.top + other.size.height == area.top;
            });
            above == areas.end() ? areas.push_back(area) : void(*above = hull(*above, area));
        }
    }
    return areas;
}

}  // namespace steplab::render
