// What the interface asks the program to do.

#include "app/window/page.hpp"
#include "app/window/viewer.hpp"

namespace steplab {

void Viewer::carry_out(const ui::Request& request) {
    switch (request.kind) {
        case ui::Request::Kind::save_snapshot:
            return save_snapshot(request);
        case ui::Request::Kind::record:
            return film_ ? end_film() : begin_film();
        case ui::Request::Kind::copy_text:
            window_.copy(request.text);
            return trace_.report("copied", request.text);
        case ui::Request::Kind::open_page:
            return show_page(request.text);
        case ui::Request::Kind::open_scene:
            return files_.open(request.text);
        case ui::Request::Kind::open_lesson:
            return files_.open_lesson(request.text);
        case ui::Request::Kind::save_scene:
            return save_scene();
        case ui::Request::Kind::save_session:
            return files_.save_session(worker_->recording());
        case ui::Request::Kind::full_screen:
            return window_.toggle_full_screen();
        case ui::Request::Kind::quit:
            quit_ = true;
    }
}

void Viewer::show_page(const std::string& name) {
    const std::string file = page_file(name).string();
    if (file.empty() || !open_on_desktop(file))
        interface_.report_error("no program on this desktop opens the page " + (file.empty() ? "docs/" + name : file));
    trace_.report("page", name);
}

}  // namespace steplab
