#include "ui/plot/plot_files.hpp"

#include "core/error.hpp"
#include "io/output_file.hpp"
#include "plot/svg.hpp"

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

namespace {

void save_text(const Context& context, const std::string& name, const std::string& text) {
    try {
        OutputFile file(name);
        file.write(text);
        file.commit();
        context.state.notice = notice_of_saved(name);
    } catch (const Error& error) {
        context.state.wanted.refuse(error.what());
    }
}

}  // namespace

void save_table(const Context& context, const plot::Plot& plot) {
    save_text(context, free_name(std::filesystem::path(), plot.name, "csv"), plot::csv(plot));
}

void save_drawing(const Context& context, const plot::Plot& plot) {
    save_text(context, free_name(std::filesystem::path(), plot.name, "svg"), plot::svg(plot));
}

void save_snapshot(const Context& context, const plot::Plot& plot) {
    context.request({.kind = Request::Kind::save_snapshot,
                     .file = free_name(std::filesystem::path(), plot.name, "png"),
                     .plot = plot.name});
}

}  // namespace steplab::ui
