#pragma once

#include "render/camera.hpp"
#include "session/session_view.hpp"
#include "ui/display.hpp"

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace steplab {

/// Writes what happens in the window, a line for every change: "step 12", "playing true", "method rk4",
/// "widget play 310 6 344 32". For tests that drive the real window, and for debugging.
class Trace {
public:
    /// `file`: "-" for standard output, empty for no trace. Throws FileError if it cannot be written.
    explicit Trace(const std::string& file);

    bool wanted() const { return out_ != nullptr; }
    /// Writes "name value" if the value has changed since it was last written under this name. Throws FileError, and
    /// ReaderGone for a closed pipe.
    void report(std::string_view name, const std::string& value);
    void report(const SessionView& session);
    void report(const render::Camera& camera);
    /// Widgets reach their places in the frames after they appear. Reported are places that are the same in two frames;
    /// with `last_frame`, which no other follows, all places.
    void report(const ui::WidgetMap& widgets, bool last_frame);

private:
    struct Close {
        void operator()(std::FILE* file) const;
    };
    void report(const RunView& view);
    [[noreturn]] void fail() const;

    std::string name_;  ///< for messages
    std::unique_ptr<std::FILE, Close> out_;
    std::map<std::string, std::string, std::less<>> reported_;  ///< last value under each name
    ui::WidgetMap before_;                                      ///< widgets of the previous frame
};

}  // namespace steplab
