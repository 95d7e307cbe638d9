#include "lab/report/svg.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

namespace steplab {

namespace {

void remove_between(std::string& text, std::string_view begin, std::string_view end) {
    const std::size_t from = text.find(begin);
    const std::size_t to = from == std::string::npos ? from : text.find(end, from);
    if (to != std::string::npos) text.erase(from, to + end.size() - from);
}

/// Replaces every "<before>...<after>" by what `make` returns for the text between.
template <class Make>
std::string replaced(const std::string& text, std::string_view before, std::string_view after, Make make) {
    std::string out;
    std::size_t done = 0;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, done)) {
        const std::size_t inside = at + before.size(), end = text.find(after, inside);
        if (end == std::string::npos) break;
        out.append(text, done, at - done);
        out += make(std::string_view(text).substr(inside, end - inside));
        done = end + after.size();
    }
    return out.append(text, done);
}

/// "  0,   0,  16" -> the page's variable of colour 16.
std::string variable(std::string_view numbers) {
    const std::size_t comma = numbers.rfind(',');
    return fmt::format("var(--c{})", std::atoi(std::string(numbers.substr(comma + 1)).c_str()));
}

std::string curve_group(std::string_view number, std::span<const std::string> names) {
    std::size_t index = 0;
    std::from_chars(number.data(), number.data() + number.size(), index);
    if (index == 0 || index > names.size()) return "<g>";
    const std::string& name = names[index - 1];
    return fmt::format("<g class=\"curve\" data-method=\"{}\"><title>{}</title>", name.substr(0, name.find(' ')), name);
}

void remove_all(std::string& text, std::string_view what) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at))
        text.erase(at, what.size());
}

}  // namespace

const char* const svg_mark = "<circle id=\"gpPt6\" r=\"1\" fill=\"currentColor\" stroke=\"none\"/>";

std::string svg_marks() {
    return fmt::format("<svg width=\"0\" height=\"0\" style=\"position:absolute\">{}</svg>\n", svg_mark);
}

std::string placeholder(int colour) { return fmt::format("#0000{:02x}", colour); }

std::string page_svg(std::string_view file, std::span<const std::string> names) {
    const std::size_t begin = file.find("<svg");
    if (begin == std::string_view::npos) return {};
    std::string text(file.substr(begin));
    remove_between(text, "<title>", "</desc>");
    remove_between(text, "<defs>", "</defs>");
    remove_between(text, "<rect", "/>");
    remove_all(text, " id=\"gnuplot_canvas\"");
    remove_all(text, "font-family=\"sans-serif\" ");
    text = replaced(text, "rgb(", ")", variable);
    text = replaced(text, "<g id=\"", ">",
                    [&](std::string_view id) { return curve_group(id.substr(id.rfind('_') + 1), names); });
    remove_all(text,
               "<g fill=\"none\" color=\"black\" stroke=\"currentColor\" stroke-width=\"1.00\" "
               "stroke-linecap=\"butt\" stroke-linejoin=\"miter\">\n</g>\n");
    return text;
}

}  // namespace steplab
