#include "lab/report/page.hpp"

#include "lab/report/table.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <vector>

namespace steplab {

namespace {

constexpr const char* before_title = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>)";

constexpr const char* style_sheet = R"(
* { box-sizing: border-box; }
body { font: 16px/1.55 Inter, "Segoe UI", system-ui, "Noto Sans", "DejaVu Sans", sans-serif; color: var(--ink); background: var(--paper);
       max-width: 1280px; margin: 0 auto; padding: 3em 1.5em 6em; }
h1 { font-size: 2.1em; line-height: 1.2; letter-spacing: -.02em; margin: 0 0 .3em; }
h2 { font-size: 1.5em; letter-spacing: -.01em; margin: 3em 0 .4em; padding-top: 1.2em; border-top: 1px solid var(--line); }
nav + h2 { margin-top: 1.2em; border: 0; padding: 0; }
h3 { font-size: 1.05em; margin: 2.2em 0 .4em; }
p, ul, ol { max-width: 46em; margin: .4em 0 .8em; } ul, ol { padding-left: 1.3em; } li { margin: .25em 0; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
code { font: .92em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--tint); padding: .1em .35em; border-radius: 4px; overflow-wrap: anywhere; }
.lead { font-size: 1.1em; } .quiet { color: var(--faint); font-size: .9em; } .good { white-space: nowrap; }
nav { display: flex; flex-wrap: wrap; gap: .5em; margin: 1.2em 0; }
nav a { background: var(--tint); border-radius: 999px; padding: .2em .9em; font-size: .92em; }
dl.made { display: flex; flex-wrap: wrap; gap: .3em 2em; margin: 1em 0; font-size: .88em; }
dl.made div { display: flex; gap: .5em; } dt { color: var(--faint); } dd { margin: 0; }
.wide { overflow-x: auto; margin: .5em 0 1.2em; }
table { border-collapse: collapse; font-size: .88em; line-height: 1.35; }
th { text-align: left; font-weight: 600; color: var(--faint); border-bottom: 1px solid var(--strong); padding: .35em 1.4em .35em 0; vertical-align: bottom; white-space: nowrap; }
td { border-bottom: 1px solid var(--line); padding: .35em 1.4em .35em 0; font-variant-numeric: tabular-nums; vertical-align: top; white-space: nowrap; }
td.note, td .note { white-space: normal; } td:last-child { white-space: normal; min-width: 6em; }
tbody tr:hover { background: var(--tint); } td small { color: var(--faint); font-size: .9em; }
.columns { display: flex; flex-wrap: wrap; gap: 0 3em; } .columns > div { flex: 1 1 480px; min-width: 0; }
.diagrams { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 500px), 1fr)); gap: 1.2em 1.5em; margin: 1em 0 .6em; }
.diagrams:has(> :only-child) { max-width: 640px; }
figure { margin: 0; overflow-x: auto; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .7em .7em .3em; min-width: 0; }
figure > svg { display: block; width: 100%; min-width: 500px; max-width: 680px; height: auto; font-family: inherit; }
figcaption { font-weight: 600; font-size: .92em; margin: 0 0 .2em .2em; }
.legend { font-size: .88em; line-height: 1.9; max-width: none; } .legend [data-name] { white-space: nowrap; margin-right: 1em; }
.dot { display: inline-block; width: .62em; height: .62em; border-radius: 50%; margin-right: .4em; }
[data-name] { cursor: default; } .curve.on { stroke: var(--hot); fill: var(--hot); } .curve.on polyline { stroke-width: 3; }
span.on { color: var(--hot); }
@media (max-width: 600px) { body { padding: 1.5em 1em 4em; } h1 { font-size: 1.7em; } }
@media print { figure { break-inside: avoid; } nav { display: none; } }
)";

/// Moving the mouse over a method's name or curve highlights its curves.
constexpr const char* script = R"(<script>
addEventListener('pointerover', event => {
  const method = event.target.closest?.('[data-name]')?.dataset.name;
  for (const old of document.querySelectorAll('.on')) old.classList.remove('on');
  if (method) for (const one of document.querySelectorAll(`[data-name="${method}"]`)) {
    one.classList.add('on');
    if (one.matches('.curve')) one.parentNode.append(one);
  }
});
</script>
)";

struct Shades {
    const char *name, *light, *dark;
};

constexpr std::array shades{
    Shades{"paper", "#fbfbf9", "#14171b"}, Shades{"card", "#ffffff", "#1a1e24"}, Shades{"ink", "#1d2329", "#e4e7ea"},
    Shades{"faint", "#626b75", "#9aa4ae"}, Shades{"line", "#e4e6e8", "#2b3138"}, Shades{"strong", "#b9bfc5", "#4a525b"},
    Shades{"tint", "#f0f2f3", "#22272e"},  Shades{"link", "#2457a6", "#7db0ff"}, Shades{"hot", "#e0457b", "#ff77a8"},
    Shades{"quiet", "#c3c8cd", "#474e57"},
};

/// rk4 first, then colours that can be distinguished in light and dark mode.
constexpr std::array palette{
    Shades{"", "#1d2329", "#e4e7ea"}, Shades{"", "#2f6fbb", "#6ea8ff"}, Shades{"", "#c8433f", "#ff8078"},
    Shades{"", "#2a8c4a", "#5fd082"}, Shades{"", "#a87400", "#e8b93a"}, Shades{"", "#8a4fb0", "#c79af0"},
    Shades{"", "#128a94", "#4fd0d8"}, Shades{"", "#8c5a35", "#d0a078"}, Shades{"", "#c2478f", "#f58ac8"},
    Shades{"", "#6b7a12", "#bccb55"}, Shades{"", "#44509c", "#a0acff"}, Shades{"", "#d9691e", "#ff9c55"},
};

constexpr std::size_t most_colours = 32;  // of the methods of a page

const Shades& shades_of(std::size_t colour) {
    return palette[colour == 0 ? 0 : 1 + (colour - 1) % (palette.size() - 1)];
}

std::string variables(bool dark) {
    std::string text;
    const auto add = [&](const std::string& name, const Shades& shade) {
        text += fmt::format("--{}:{};", name, dark ? shade.dark : shade.light);
    };
    for (const Shades& shade : shades) add(shade.name, shade);
    for (std::size_t i = 0; i < most_colours; ++i) add(fmt::format("c{}", i), shades_of(i));
    return text;
}

/// `ink` makes a colour of a variable of the page.
template <class Ink>
plot::Inks inks_of(const Ink& ink) {
    plot::Inks inks{.paper = ink("card"),
                    .text = ink("faint"),
                    .dim = ink("faint"),
                    .grid = ink("line"),
                    .exact = ink("ink"),
                    .quiet = ink("quiet"),
                    .curves = {}};
    for (std::size_t i = 0; i < most_colours; ++i) inks.curves.push_back(ink(fmt::format("c{}", i)));
    return inks;
}

/// They follow light and dark mode.
plot::Inks page_inks() {
    return inks_of([](const std::string& name) { return fmt::format("var(--{})", name); });
}

}  // namespace

const char* const page_end = "</body></html>\n";

std::string page_head(const std::string& title, const std::string& what, const Circumstances& made) {
    std::string page = before_title + title + " – steplab</title>\n<style>\n:root{color-scheme:light dark;" +
                       variables(false) + "}\n@media (prefers-color-scheme: dark){:root{" + variables(true) + "}}" +
                       style_sheet + "</style>\n" + script + "</head><body>\n";
    page += fmt::format("<h1>{}</h1>\n<p class=\"lead\">{}</p>\n<dl class=\"made\">", title, what);
    for (const auto& [name, value] :
         {std::pair("machine", made.processor), std::pair("compiler", made.compiler),
          std::pair("steplab", made.version), std::pair("commit", made.commit), std::pair("measured", made.date)})
        page += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, escaped(value));
    return page + "</dl>\n";
}

plot::Inks light_inks() {
    std::map<std::string, std::string> light;
    for (const Shades& shade : shades) light[shade.name] = shade.light;
    for (std::size_t i = 0; i < most_colours; ++i) light[fmt::format("c{}", i)] = shades_of(i).light;
    return inks_of([&](const std::string& name) { return light.at(name); });
}

std::string captioned(const std::string& caption, const plot::Plot& figure) {
    return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", caption, svg_element(figure, page_inks()));
}

std::string method_name(const std::string& id, std::optional<std::size_t> colour) {
    const std::string dot =
        colour ? fmt::format("<span class=\"dot\" style=\"background:var(--c{})\"></span>", *colour) : "";
    return fmt::format("<span data-name=\"{0}\">{1}{0}</span>", id, dot);
}

}  // namespace steplab
