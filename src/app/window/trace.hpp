#pragma once

#include "render/camera.hpp"
#include "sim/run/run_view.hpp"
#include "ui/display.hpp"

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace steplab {

/// Tells what happens in the window, a line for every change: "step 12", "playing true", "method rk4",
/// "widget play 310 6 344 32". For tests that drive the real window, and for whoever wants to know what it does.
class Trace {
public:
    /// `file`: "-" for standard output, empty for nobody. Throws FileError if it cannot be written.
    explicit Trace(const std::string& file);

    bool wanted() const { return out_ != nullptr; }
    /// Writes "name value" if the value is not the one written last under this name.
    void tell(std::string_view name, const std::string& value);
    void tell(const RunView& view);
    void tell(const render::Camera& camera);
    /// Widgets find their places in the frames after the one they appear in: told is what two frames agree on, or what
    /// stays because no frame comes after this one.
    void tell(const ui::WidgetMap& widgets, bool last_frame);

private:
    struct Close {
        void operator()(std::FILE* file) const;
    };
    std::unique_ptr<std::FILE, Close> out_;
    std::map<std::string, std::string, std::less<>> told_;
    ui::WidgetMap before_;  ///< widgets of the frame before
};

}  // namespace steplab
