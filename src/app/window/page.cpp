#include "app/window/page.hpp"

#include "io/child_program.hpp"
#include "io/shared_files.hpp"

#include <system_error>

namespace steplab {

std::filesystem::path page_file(const std::string& name) {
    for (const auto& folder : shared_folders("")) {
        // share/steplab/ beside share/doc/steplab/, and assets/ beside docs/
        for (const char* const pages : {"../../doc/steplab/docs", "../docs"}) {
            auto file = (folder / pages / name).lexically_normal();
            std::error_code error;
            if (std::filesystem::exists(file, error)) return file;
        }
    }
    return {};
}

bool open_on_desktop(const std::filesystem::path& file) {
    // the shell ends at once and leaves the program to itself
    ChildProgram shell({"sh", "-c", R"(command -v xdg-open >/dev/null || exit 1; xdg-open "$1" >/dev/null 2>&1 &)",
                        "sh", file.string()});
    return shell.end() == ChildProgram::End::done;
}

}  // namespace steplab
