#include "ui/plot/plot_files.hpp"

#include "core/error.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab::ui {

std::string free_name(const std::filesystem::path& folder, std::string_view name, std::string_view end) {
    std::string words(name);
    std::replace(words.begin(), words.end(), ' ', '-');
    for (int i = 1;; ++i) {
        std::string file = (folder / fmt::format("steplab-{}-{}.{}", words, i, end)).string();
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) return file;
    }
}

void save_table(const Context& context, const Plot& plot) {
    const std::string name = free_name(std::filesystem::path(), plot.widget, "csv");
    try {
        OutputFile file(name);
        file.write(plot_csv(plot));
        file.commit();
        context.state.notice = notice_of_saved(name);
    } catch (const Error& error) {
        context.state.wanted.refuse(error.what());
    }
}

void save_snapshot(const Context& context, const Plot& plot, const Area& area) {
    context.request({.kind = Request::Kind::save_snapshot,
                     .file = free_name(std::filesystem::path(), plot.widget, "png"),
                     .part = pixels(area)});
}

}  // namespace steplab::ui
