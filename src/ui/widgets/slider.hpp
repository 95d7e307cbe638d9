#pragma once

#include "ui/context.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// The range of a slider.
struct SliderRange {
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    bool whole = false;  ///< integers only

    /// Position 0 .. 1 of a value along the slider, and back; values outside the range are at its ends.
    double part(double value) const;
    double value(double part) const;
};

/// The appearance of a slider.
struct SliderStyle {
    ImU32 fill = colour::accent;
    std::optional<double> mark = {};  ///< a value marked by a red line if it is in the range
};

/// A row of the panel: label, slider and the value with its unit. A double click sets the default; Ctrl + click or a
/// click on the value opens a text entry for any value.
struct SliderRow {
    std::string_view widget;  ///< name of the widget, unique in the interface
    std::string_view label;
    std::string_view tooltip;
    std::string value_text;  ///< as shown
    std::string entry_text;  ///< as it is edited
    double value = 0;
    double default_value = 0;
    SliderRange range;
    SliderStyle style;
    /// Sets a dragged value; sets a typed one, which may throw UsageError.
    std::function<void(double)> set;
    std::function<void(std::string_view)> set_text;
    std::string longest_text = {};  ///< for which there has to be room, if it is longer than usual
};
void slider_row(const Context& context, const SliderRow& row);

/// A slider without label, of this size in pixels. Returns the new value if it is moved.
std::optional<double> slider(const Context& context, std::string_view widget, double value, const SliderRange& range,
                             const SliderStyle& style, float width, float height);

}  // namespace steplab::ui
