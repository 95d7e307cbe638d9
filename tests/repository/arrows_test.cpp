#include "repository/arrows.hpp"

#include <gmock/gmock.h>

namespace steplab::repository {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Arrows, folders_include_only_what_the_plan_allows) {
    const auto files = text_files(STEPLAB_SOURCE_DIR);
    ASSERT_GT(files.size(), 50u);  // the whole tree was read, not an empty folder
    EXPECT_THAT(forbidden_arrows(files), IsEmpty());
}

TEST(Arrows, allowed_includes_and_links_pass) {
    EXPECT_THAT(forbidden_arrows({{"src/core/a.cpp", "#include \"core/a.hpp\"\n#include <fmt/format.h>\n"},
                                  {"src/sim/a.cpp", "#include \"methods/rk4.hpp\"\n"},
                                  {"src/ui/a.cpp", "#include \"session/worker.hpp\"\n#include <imgui.h>\n"},
                                  {"src/render/a.cpp", "#include <GL/glew.h>\n"},
                                  {"src/sim/CMakeLists.txt", "steplab_library(sim LINK steplab_methods)\n"}}),
                IsEmpty());
}

TEST(Arrows, users_of_the_library_know_its_headers_alone) {
    EXPECT_THAT(forbidden_arrows({{"examples/a.cpp", "#include <steplab/scene.hpp>\n#include <cstdio>\n"},
                                  {"python/a.cpp", "#include \"arrays.hpp\"\n#include <pybind11/stl.h>\n"}}),
                IsEmpty());
    EXPECT_THAT(forbidden_arrows({{"include/steplab/a.hpp", "#include \"sim/catalogue.hpp\"\n"},
                                  {"python/a.cpp", "#include <core/vec3.hpp>\n"},
                                  {"tests/library/a.cpp", "\n#include \"lab/limits/limits.hpp\"\n"}}),
                ElementsAre("include/steplab/a.hpp:1: the library's users may not know sim",
                            "python/a.cpp:1: the library's users may not know core",
                            "tests/library/a.cpp:2: the library's users may not know lab"));
}

TEST(Arrows, include_against_an_arrow_is_found_with_file_and_line) {
    EXPECT_THAT(forbidden_arrows({{"src/core/frame.hpp", "#pragma once\n#include \"session/worker.hpp\"\n"}}),
                ElementsAre("src/core/frame.hpp:2: core may not know session"));
    EXPECT_THAT(forbidden_arrows({{"src/methods/rk4.hpp", "# include \"models/chain.hpp\"\n"}}), SizeIs(1));
    EXPECT_THAT(forbidden_arrows({{"src/render/spheres.cpp", "#include \"sim/run/simulation.hpp\"\n"}}), SizeIs(1));
    EXPECT_THAT(forbidden_arrows({{"src/ui/panels/a.cpp", "#include \"lab/study/answers.hpp\"\n"}}), SizeIs(1));
    EXPECT_THAT(forbidden_arrows({{"src/sim/catalogue.cpp.in", "#include \"ui/panel.hpp\"\n"}}), SizeIs(1));
}

TEST(Arrows, drawing_libraries_in_the_core_are_found) {
    for (const char* header : {"<GL/glew.h>", "<GLFW/glfw3.h>", "<imgui.h>", "<EGL/egl.h>", "<glm/glm.hpp>"}) {
        for (const char* folder : {"core", "methods", "models", "sim", "io", "lab", "session"}) {
            const TextFile file{std::filesystem::path("src") / folder / "a.cpp", std::string("#include ") + header};
            EXPECT_THAT(forbidden_arrows({file}), SizeIs(1)) << folder << ' ' << header;
        }
    }
}

TEST(Arrows, link_against_an_arrow_and_unknown_folder_are_found) {
    EXPECT_THAT(forbidden_arrows({{"src/render/CMakeLists.txt", "steplab_library(render LINK steplab_sim)\n"}}),
                ElementsAre("src/render/CMakeLists.txt:1: render may not know sim"));
    EXPECT_THAT(forbidden_arrows({{"src/utils/a.cpp", "int x;\n"}}), SizeIs(1));
}

TEST(Arrows, include_that_is_not_named_from_src_is_found) {
    EXPECT_THAT(forbidden_arrows({{"src/sim/run/worker.cpp", "#include \"worker.hpp\"\n"}}), SizeIs(1));
}

}  // namespace
}  // namespace steplab::repository
