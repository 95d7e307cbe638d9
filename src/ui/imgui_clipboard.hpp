// The clipboard of an interface as ImGui uses it.
#pragma once

#include "ui/interface.hpp"

#include <string>

namespace steplab::ui {

/// The clipboard in the form ImGui calls it: the text has to stay valid after the call.
struct ImGuiClipboard {
    Clipboard clipboard;
    std::string text;

    static ImGuiClipboard& of(void* self) { return *static_cast<ImGuiClipboard*>(self); }
    static const char* read(void* self) {
        of(self).text = of(self).clipboard.read();
        return of(self).text.c_str();
    }
    static void write(void* self, const char* text) { of(self).clipboard.write(text); }
};

}  // namespace steplab::ui
