#pragma once

#include "ui/context.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// What a slider moves over.
struct SliderRange {
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    bool whole = false;  ///< whole numbers only

    /// 0 .. 1 along the slider, and back; values outside the range are at its ends.
    double part(double value) const;
    double value(double part) const;
};

/// How a slider looks.
struct SliderStyle {
    ImU32 fill = colour::accent;
    std::optional<double> mark = {};  ///< a value that is marked by a red line, if it lies in the range
};

/// One line of the panel: label, slider and the value with its unit. Double click sets the default, Ctrl+click or a
/// click on the value opens an entry for any value.
struct SliderRow {
    std::string_view widget;  ///< name of the widget, unique in the interface
    std::string_view label;
    std::string_view tooltip;
    std::string value_text;  ///< as shown
    std::string entry_text;  ///< as it is offered for editing
    double value = 0;
    double default_value = 0;
    SliderRange range;
    SliderStyle style;
    /// Sets a value that was dragged; sets one that was typed, which may throw UsageError.
    std::function<void(double)> set;
    std::function<void(std::string_view)> set_text;
};
void slider_row(const Context& context, const SliderRow& row);

/// A slider alone, of this size in pixels; the new value if the person moves it.
std::optional<double> slider(const Context& context, std::string_view widget, double value, const SliderRange& range,
                             const SliderStyle& style, float width, float height);

}  // namespace steplab::ui
