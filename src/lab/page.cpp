#include "lab/page.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

constexpr const char* before_title = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>)";

constexpr const char* after_title = R"( – steplab</title>
<style>
body { font: 16px/1.5 Inter, "Segoe UI", system-ui, sans-serif; color: #222; background: #fdfdfc;
       max-width: 1320px; margin: 2.5em auto; padding: 0 1.5em; }
h1 { font-size: 2em; margin: 0; } h2 { margin: 2.4em 0 .3em; font-size: 1.45em; } h3 { margin: 1.6em 0 .3em; font-size: 1.05em; }
p { max-width: 52em; } .quiet { color: #666; font-size: .9em; }
table { border-collapse: collapse; font-size: .88em; margin: .6em 0 1.2em; }
th { text-align: left; font-weight: 600; border-bottom: 2px solid #ccc; padding: .25em 1.1em .25em 0; vertical-align: bottom; }
td { border-bottom: 1px solid #eee; padding: .22em 1.1em .22em 0; font-variant-numeric: tabular-nums; }
.row { display: flex; flex-wrap: wrap; gap: 1em 1.5em; } figure { margin: 0; } figure svg { width: 620px; max-width: 100%; height: auto; }
figcaption { font-weight: 600; font-size: .95em; }
nav a { margin-right: 1.2em; } a { color: #2a5d9f; }
</style></head><body>
)";

}  // namespace

std::string page_head(const std::string& title, const Circumstances& made) {
    return before_title + title + after_title +
           fmt::format(
               "<h1>{}</h1>\n<p class=\"quiet\">steplab {} ({}), {}; {}; {}. Times are of the stepping alone, "
               "the least of interleaved rounds, on one core: compare them with each other, not with those of "
               "another machine.</p>\n",
               title, made.version, made.commit, made.compiler, made.processor, made.date);
}

std::string captioned(const std::string& caption, const std::string& svg) {
    return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", caption, svg);
}

}  // namespace steplab
