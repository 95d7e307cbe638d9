#include "repository/files.hpp"
#include "sections.hpp"
#include "sim/catalogue.hpp"
#include "tables.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace steplab::repository {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string page(const std::string& path) {
    for (const TextFile& file : pages(STEPLAB_SOURCE_DIR)) {
        if (file.path == path) return file.text;
    }
    throw std::runtime_error(path + " is not in the repository");
}

std::string made(const std::string& name) { return docs::section(name, std::string(STEPLAB_BINARY_DIR) + "/bin"); }

/// A section of a page that is made, with its marks.
struct MadeSection {
    std::string page;
    std::size_t number = 0;  ///< in its page
    std::string text;

    friend std::ostream& operator<<(std::ostream& out, const MadeSection& section) {
        return out << section.page << ", made section " << section.number;
    }
};

/// Those of a page. One without an end reaches to that of the page.
std::vector<MadeSection> made_sections_of(const TextFile& page) {
    const std::string begin_mark = "\n<!-- made: ", end_mark = "<!-- made end -->\n";
    std::vector<MadeSection> sections;
    for (std::size_t at = 0; (at = page.text.find(begin_mark, at)) != std::string::npos; ++at) {
        const std::size_t end = page.text.find(end_mark, at), length = end + end_mark.size() - at - 1;
        sections.push_back({page.path.string(), sections.size() + 1,
                            page.text.substr(at + 1, end == std::string::npos ? end : length)});
    }
    return sections;
}

std::vector<MadeSection> made_sections() {
    std::vector<MadeSection> all;
    for (const TextFile& page : pages(STEPLAB_SOURCE_DIR)) {
        for (const MadeSection& section : made_sections_of(page)) all.push_back(section);
    }
    return all;
}

/// The page, the number of the section there, and what it is of: "README_2_methods".
std::string section_name(const testing::TestParamInfo<MadeSection>& test) {
    const std::string of = test.param.text.substr(10, test.param.text.find(" -->") - 10);
    return name_in_tests(fmt::format("{}_{}_{}", name_in_tests(test.param.page), test.param.number, of.substr(0, 40)));
}

class MadeSections : public testing::TestWithParam<MadeSection> {};

TEST_P(MadeSections, are_up_to_date) {
    EXPECT_EQ(docs::with_sections_made(GetParam().text, made), GetParam().text)
        << GetParam().page << ": run scripts/update-docs.sh";
}

INSTANTIATE_TEST_SUITE_P(Docs, MadeSections, testing::ValuesIn(made_sections()), section_name);

TEST(Docs, made_sections_are_found) {
    const std::string two = "<!-- made: a -->\nb\n<!-- made end -->\n", more = "<!-- made: c -->\n<!-- made end -->\n";
    const auto sections = made_sections_of({"x.md", "# Page\n" + two + "made:\n" + more});
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_EQ(sections[0].text, two);
    EXPECT_EQ(sections[1].text, more);
    const auto broken = made_sections_of({"x.md", "# Page\n<!-- made: keys -->\nold\n"});
    ASSERT_EQ(broken.size(), 1u);
    EXPECT_THROW(docs::with_sections_made(broken[0].text, made), std::runtime_error);
}

TEST(Docs, section_out_of_date_is_made_anew) {
    const std::string old_page = "before\n<!-- made: a -->\nold\n<!-- made end -->\nafter\n";
    const auto make = [](const std::string& name) { return "new " + name + "\n"; };
    EXPECT_EQ(docs::with_sections_made(old_page, make), "before\n<!-- made: a -->\nnew a\n<!-- made end -->\nafter\n");
}

TEST(Docs, broken_section_is_refused) {
    EXPECT_THROW(docs::with_sections_made("<!-- made: models -->\nold\n", made), std::runtime_error);
    EXPECT_THROW(made("no such section"), std::runtime_error);
    EXPECT_THROW(made("$ false"), std::runtime_error);
}

TEST(Docs, every_model_and_method_is_in_the_tables_of_the_first_page) {
    const std::string readme = page("README.md");
    const auto has_row = [&](std::string_view id) {
        return readme.find(fmt::format("\n| `{}` |", id)) != std::string::npos;
    };
    for (const Model& model : models()) EXPECT_TRUE(has_row(model.info.id)) << model.info.id;
    for (const Method& method : methods()) EXPECT_TRUE(has_row(method.info.id)) << method.info.id;
    EXPECT_FALSE(has_row("no-such-method"));
}

TEST(Docs, units_of_all_parameters_are_in_the_table_of_units) {
    const std::string units = page("docs/units.md");
    for (const Model& model : models()) {
        for (const ParameterInfo& info : model.info.parameters) {
            const std::string unit = info.unit.empty() ? "1" : std::string(info.unit);
            EXPECT_THAT(units, HasSubstr("| " + unit + " |")) << model.info.id << ' ' << info.name;
        }
    }
}

/// The diagram stands on white, so that it can be read on dark pages too, and is light to load.
bool is_fit_for_a_page(const std::string& svg) {
    return svg.find("fill=\"#ffffff\"") != std::string::npos && svg.find("<polyline") != std::string::npos &&
           svg.size() < 64000;
}

TEST(Docs, every_hard_case_has_its_table_and_diagram) {
    const std::string hard_cases = page("docs/hard-cases.md");
    for (const HardCase& each : steplab::hard_cases()) {
        EXPECT_THAT(hard_cases, HasSubstr(fmt::format("<!-- made: hard case {} -->", each.id)));
        std::ostringstream svg;
        svg << std::ifstream(std::filesystem::path(STEPLAB_SOURCE_DIR) / "docs/images" / docs::picture_name(each))
                   .rdbuf();
        EXPECT_TRUE(is_fit_for_a_page(svg.str())) << each.id << ": run scripts/update-pictures.sh";
    }
    EXPECT_FALSE(is_fit_for_a_page("<svg><polyline/></svg>"));
}

TEST(Docs, links_lead_to_files) {
    const std::filesystem::path root = STEPLAB_SOURCE_DIR;
    for (const TextFile& file : pages(STEPLAB_SOURCE_DIR)) {
        for (const std::string& target : docs::linked_files(file.text)) {
            EXPECT_TRUE(std::filesystem::exists(root / file.path.parent_path() / target))
                << file.path << ": " << target;
        }
    }
}

TEST(Docs, pages_that_the_code_points_to_exist) {
    static const std::regex reference(R"(docs/[a-z-]+\.md)");
    for (const TextFile& file : text_files(STEPLAB_SOURCE_DIR)) {
        for (auto match = std::sregex_iterator(file.text.begin(), file.text.end(), reference);
             match != std::sregex_iterator(); ++match) {
            EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(STEPLAB_SOURCE_DIR) / match->str()))
                << file.path << ": " << match->str();
        }
    }
}

TEST(Docs, every_page_is_in_the_menu_of_the_site) {
    std::stringstream menu;
    menu << std::ifstream(std::filesystem::path(STEPLAB_SOURCE_DIR) / "docs/site/mkdocs.yml").rdbuf();
    for (const TextFile& file : pages(STEPLAB_SOURCE_DIR)) {
        if (file.path.parent_path() != "docs") continue;
        EXPECT_THAT(menu.str(), HasSubstr(": " + file.path.filename().string() + "\n"));
    }
}

TEST(Docs, links_are_found) {
    EXPECT_THAT(docs::linked_files("![a](docs/a.png), [b](b.md#part), [c](#part), [d](https://example.org/d)"),
                ElementsAre("docs/a.png", "b.md"));
}

TEST(Docs, examples_are_found_in_shell_blocks_and_indented_ones_only) {
    EXPECT_THAT(
        docs::examples(
            "```sh\nsteplab list  # all\nls\nsteplab run \\\n--steps 3\n```\n```\nsteplab no\n    steplab no\n```\n"
            "steplab no\n    steplab report\n    steplab run \\\n        --steps 4\n"),
        ElementsAre("steplab list", "steplab run  --steps 3", "steplab report", "steplab run      --steps 4"));
}

}  // namespace
}  // namespace steplab::repository
