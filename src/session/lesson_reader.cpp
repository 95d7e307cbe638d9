#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/terms.hpp"
#include "core/text.hpp"
#include "io/input_file.hpp"
#include "io/shared_files.hpp"
#include "io/toml_text.hpp"
#include "session/lesson.hpp"
#include "session/session.hpp"
#include "session/session_file.hpp"
#include "session/toml_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

constexpr std::uint64_t largest_lesson = std::uint64_t{1} << 20;
constexpr std::size_t most_terms = 12;

/// Text on several lines of a file is one paragraph; an empty line ends it.
std::string paragraphs(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r') continue;
        const bool joins =
            text[i] == '\n' && i + 1 < text.size() && text[i + 1] != '\n' && i > 0 && text[i - 1] != '\n';
        result += joins ? ' ' : text[i];
    }
    result.erase(0, result.find_first_not_of(" \n"));
    result.erase(result.find_last_not_of(" \n") + 1);
    return result;
}

std::string paragraph_of(const toml::node& node) {
    std::string text = paragraphs(text_of(node));
    if (text.empty()) fail_at(node, "must not be empty");
    return text;
}

template <class Entries>
std::vector<std::string_view> ids_of(const Entries& entries) {
    std::vector<std::string_view> ids;
    ids.reserve(entries.size());
    for (const auto& entry : entries) ids.push_back(entry.id);
    return ids;
}

std::vector<std::string> words_of(const toml::node& node, std::string_view what, std::size_t most,
                                  const std::vector<std::string_view>& known) {
    std::vector<std::string> words;
    for (const toml::node* const element :
         elements_of(node, fmt::format("1 to {} of: {}", most, joined(known)), 1, most))
        words.push_back(word_of(*element, what, known));
    return words;
}

void read_between(const toml::node& node, LessonFact& fact) {
    const auto bounds = elements_of(node, "two numbers, [from, to]", 2, 2);
    fact.least = number_of(*bounds[0]);
    fact.most = number_of(*bounds[1]);
    if (!(fact.least <= fact.most)) fail_at(node, "the first number must not be greater than the second");
}

std::size_t run_of(const toml::node& node) {
    const std::uint64_t run = count_of(node);
    if (run >= Session::most_runs) fail_at(node, fmt::format("must be a run, 0 to {}", Session::most_runs - 1));
    return run;
}

LessonFact fact_of(const toml::table& table) {
    LessonFact fact;
    read_keys(table, "[[pages.facts]]",
              {{"says", [&](const toml::node& node) { fact.says = paragraph_of(node); }},
               {"quantity",
                [&](const toml::node& node) { fact.quantity = word_of(node, "quantity", ids_of(lesson_quantities)); }},
               {"run", [&](const toml::node& node) { fact.run = run_of(node); }},
               {"over", [&](const toml::node& node) { fact.over = run_of(node); }},
               {"step", [&](const toml::node& node) { fact.step = count_of(node); }},
               {"between", [&](const toml::node& node) { read_between(node, fact); }}});
    for (const std::string_view key : {"says", "quantity", "between"}) needed(table, "a fact", key);
    return fact;
}

/// The number of events up to the first bookmark of this text, that one included, behind the first `from`.
std::size_t end_of_part(const toml::node& node, const Recording& session, std::size_t from) {
    const std::string text = text_of(node);
    std::vector<std::string_view> later;
    for (std::size_t i = from; i < session.events.size(); ++i) {
        const auto* const mark = std::get_if<event::Bookmark>(&session.events[i].event);
        if (mark && mark->text == text) return i + 1;
        if (mark) later.push_back(mark->text);
    }
    if (later.empty()) fail_at(node, "the session has no bookmark behind the page before");
    fail_at(node, unknown_word("bookmark", text, later, "the session behind the page before"));
}

/// The words of a fact are in the page that they are about.
void check_words(const toml::table& table, const LessonPage& page) {
    for (const LessonFact& fact : page.facts) {
        const auto has = [&](const std::string& text) { return text.find(fact.says) != std::string::npos; };
        if (!has(page.text) && !has(page.act) && !has(page.watch) && !has(page.shows))
            fail_at(table, fmt::format("the page does not have the words of its fact: \"{}\"", shown(fact.says)));
    }
}

void check_page(const toml::table& table, const LessonPage& page) {
    needed(table, "a page", "title");
    needed(table, "a page", "text");
    if (page.has_part()) {
        for (const std::string_view key : {"do", "watch", "shows"}) needed(table, "a page with 'to'", key);
    } else if (!page.facts.empty() || !page.act.empty()) {
        fail_at(table, "a page that does something needs 'to', the bookmark of the session at which it ends");
    }
    check_words(table, page);
}

LessonPage page_of(const toml::table& table, const Recording& session, std::size_t from) {
    LessonPage page{.from = from, .to = from};
    const auto paragraph = [](std::string& text) {
        return [&text](const toml::node& node) { text = paragraph_of(node); };
    };
    read_keys(
        table, "[[pages]]",
        {{"title", paragraph(page.title)},
         {"text", paragraph(page.text)},
         {"do", paragraph(page.act)},
         {"watch", paragraph(page.watch)},
         {"shows", paragraph(page.shows)},
         {"to", [&](const toml::node& node) { page.to = end_of_part(node, session, from); }},
         {"plots",
          [&](const toml::node& node) {
              page.plots = words_of(node, "plot", lesson_plots.size(), {lesson_plots.begin(), lesson_plots.end()});
          }},
         {"terms", [&](const toml::node& node) { page.terms = words_of(node, "term", most_terms, ids_of(terms())); }},
         {"speed",
          [&](const toml::node& node) {
              page.speed = number_of(node);
              if (!(*page.speed > 0)) fail_at(node, "a speed must be > 0");
          }},
         {"facts", [](const toml::node&) {}}});
    each_table(table, "facts", [&](const toml::table& fact) { page.facts.push_back(fact_of(fact)); });
    check_page(table, page);
    return page;
}

Lesson lesson_of(const toml::table& root, Recording session) {
    const toml::node* const version = root.get("steplab-lesson");
    if (!version) throw SceneProblem({1, 1}, "a lesson file begins with its version: steplab-lesson = 1");
    if (integer_of(*version) != 1) fail_at(*version, "this program reads version 1: steplab-lesson = 1");
    Lesson lesson;
    read_keys(root, "a lesson file",
              {{"steplab-lesson", [](const toml::node&) {}},
               {"title", [&](const toml::node& node) { lesson.title = paragraph_of(node); }},
               {"teaches", [&](const toml::node& node) { lesson.teaches = paragraph_of(node); }},
               {"order", [&](const toml::node& node) { lesson.order = count_of(node); }},
               {"pages", [](const toml::node&) {}}});
    for (const std::string_view key : {"title", "teaches", "pages"}) needed(root, "a lesson file", key);
    each_table(root, "pages", [&](const toml::table& table) {
        lesson.pages.push_back(page_of(table, session, lesson.pages.empty() ? 0 : lesson.pages.back().to));
    });
    if (lesson.pages.empty()) fail_at(root, "a lesson needs [[pages]]");
    lesson.session = std::make_shared<const Recording>(std::move(session));
    return lesson;
}

}  // namespace

LessonTitle title_of(const Lesson& lesson) {
    const RunDescription& start = lesson.session->start;
    return {lesson.id, lesson.title, lesson.teaches, start.origin ? start.origin->given : start.model, lesson.order};
}

Lesson parse_lesson(const std::string& text, const std::string& name, Recording session) {
    return in_file(name, [&] { return lesson_of(toml_table(text, name), std::move(session)); });
}

Lesson read_lesson_file(const std::filesystem::path& path) {
    const InputFile file(path.string());
    if (file.size() > largest_lesson)
        throw FileError(fmt::format("'{}': a lesson file has at most 1 MB", shown(path.string())));
    Recording session = read_session_file(std::filesystem::path(path).replace_extension(".session").string());
    Lesson lesson = parse_lesson(file.read(0, file.size()), path.string(), std::move(session));
    lesson.id = path.stem().string();
    return lesson;
}

Lesson find_lesson(const std::string& name) {
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
    const std::filesystem::path path = is_file ? std::filesystem::path(name) : shared_file("lessons", name + ".toml");
    if (!path.empty()) return read_lesson_file(path);
    const std::vector<std::string> names = shared_names("lessons", ".toml");
    throw UsageError(unknown_word("lesson", name, std::vector<std::string_view>(names.begin(), names.end())));
}

std::vector<Lesson> shipped_lessons() {
    std::vector<Lesson> lessons;
    for (const std::string& name : shared_names("lessons", ".toml")) lessons.push_back(find_lesson(name));
    std::stable_sort(lessons.begin(), lessons.end(),
                     [](const Lesson& a, const Lesson& b) { return a.order < b.order; });
    return lessons;
}

}  // namespace steplab
