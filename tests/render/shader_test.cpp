#include "core/error.hpp"
#include "io/files.hpp"
#include "render/shader_program.hpp"
#include "render/studio.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace steplab::render {
namespace {

using testing::HasSubstr;

class Shaders : public test::Studio {
protected:
    void put(const std::string& name, const std::string& text) const { put_text(folder_.file(name), text); }
    std::string path(const std::string& name) const { return folder_.file(name); }
    void compile() const { ShaderProgram("a.vert", "a.frag", {folder_.path()}); }
    void put_good_ones() const {
        put("a.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n");
        put("a.frag", "#version 330 core\nout vec4 f_colour;\nvoid main() { f_colour = vec4(1.0); }\n");
    }
    static std::string message(const std::function<void()>& action) {
        try {
            action();
        } catch (const GraphicsError& error) {
            return error.what();
        }
        return "no error";
    }

private:
    TemporaryFolder folder_;
};

TEST_F(Shaders, good_ones_compile) {
    put_good_ones();
    EXPECT_NO_THROW(compile());
}

TEST_F(Shaders, error_names_file_and_line) {
    put_good_ones();
    put("a.frag", "#version 330 core\nout vec4 f_colour;\nvoid main() {\n    f_colour = nonsense;\n}\n");
    EXPECT_THAT(message([&] { compile(); }), HasSubstr(path("a.frag") + ":4"));
}

TEST_F(Shaders, error_in_an_included_file_names_that_file) {
    put_good_ones();
    put("b.glsl", "// a comment\nfloat half_of(float x) { return 0.5 * y; }\n");
    put("a.frag",
        "#version 330 core\n\n#include \"b.glsl\"\nout vec4 f_colour;\nvoid main() { f_colour = vec4(1.0); }\n");
    EXPECT_THAT(message([&] { compile(); }), HasSubstr(path("b.glsl") + ":2"));
}

TEST_F(Shaders, error_after_an_included_file_names_the_right_line) {
    put_good_ones();
    put("b.glsl", "float half_of(float x) { return 0.5 * x; }\n\n\n\n");
    put("a.frag", "#version 330 core\n#include \"b.glsl\"\nout vec4 f_colour;\nvoid main() { f_colour = wrong; }\n");
    EXPECT_THAT(message([&] { compile(); }), HasSubstr(path("a.frag") + ":4"));
}

TEST_F(Shaders, that_include_themselves_are_refused) {
    put_good_ones();
    put("a.frag", "#version 330 core\n#include \"b.glsl\"\nvoid main() {}\n");
    put("b.glsl", "#include \"c.glsl\"\n");
    put("c.glsl", "#include \"b.glsl\"\n");
    EXPECT_THAT(message([&] { compile(); }), HasSubstr("includes itself: a.frag > b.glsl > c.glsl > b.glsl"));
}

// Each file twice includes the next: twenty of them make a million.
TEST_F(Shaders, that_include_too_much_are_refused) {
    put_good_ones();
    put("a.frag", "#version 330 core\n#include \"0.glsl\"\nvoid main() {}\n");
    for (int i = 0; i < 20; ++i) {
        const std::string next = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
        put(std::to_string(i) + ".glsl", next + next);
    }
    put("20.glsl", "\n");
    EXPECT_THAT(message([&] { compile(); }), HasSubstr("includes more than"));
}

TEST_F(Shaders, missing_one_names_the_searched_folders) {
    put_good_ones();
    const std::string text = message([&] { ShaderProgram("a.vert", "c.frag", {path("here"), path("there")}); });
    EXPECT_THAT(text, HasSubstr("a.vert"));
    EXPECT_THAT(text, HasSubstr(path("here")));
    EXPECT_THAT(text, HasSubstr(path("there")));
}

TEST_F(Shaders, stages_that_do_not_fit_are_named) {
    put("a.vert",
        "#version 330 core\nout vec2 v_place;\nvoid main() { gl_Position = vec4(v_place = vec2(1.0), 0.0, 1.0); }\n");
    put("a.frag",
        "#version 330 core\nin vec3 v_place;\nout vec4 f_colour;\nvoid main() { f_colour = vec4(v_place, 1.0); }\n");
    const std::string text = message([&] { compile(); });
    EXPECT_THAT(text, HasSubstr("a.vert"));
    EXPECT_THAT(text, HasSubstr("a.frag"));
}

TEST(ShaderLog, messages_of_several_drivers_name_their_files) {
    const std::vector<std::string> files{"one.frag", "two.glsl"};
    EXPECT_EQ(named_log("1:12(5): error: bad\n", files), "two.glsl:12(5): error: bad\n");
    EXPECT_EQ(named_log("0(7) : error C1008: bad\n", files), "one.frag:7 : error C1008: bad\n");
    EXPECT_EQ(named_log("ERROR: 1:3: 'x' : bad\n", files), "ERROR: two.glsl:3: 'x' : bad\n");
    EXPECT_EQ(named_log("9:3(1): error\nsomething else\n", files), "9:3(1): error\nsomething else\n");
}

TEST(ShaderFolders, do_not_depend_on_the_working_directory) {
    for (const auto& folder : shader_folders()) EXPECT_TRUE(folder.is_absolute()) << folder;
}

}  // namespace
}  // namespace steplab::render
