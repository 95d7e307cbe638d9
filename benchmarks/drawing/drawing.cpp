// What drawing a mesh takes at 1280x720 without a display: whole frames as the window shows them, from the frame of the
// run to the bytes of the picture, in turns with a bare draw of the same positions as GL_POINTS into the same target.
//
//     drawing [--lines] [PICTURES [COLOURING [DIM...]]]
//         least times of so many pictures each (default 7); what colours tell (default role); meshes of DIM x DIM
//         particles (default 100, 316, 1000); with --lines in lines for benchmarks/results

#include "app/offscreen/context.hpp"
#include "lines.hpp"
#include "render/framing.hpp"
#include "render/gl.hpp"
#include "render/gl_objects.hpp"
#include "render/scene_renderer.hpp"
#include "render/shader_program.hpp"
#include "render/view_uniforms.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace steplab;
using namespace steplab::render;

constexpr PictureSize size{1280, 720};

/// Positions as three arrays of float, drawn as points of one pixel by the shortest program there is.
class BarePoints {
public:
    BarePoints() {
        const char* vertex_text =
            "#version 330 core\n"
            "layout(location = 0) in float x; layout(location = 1) in float y; layout(location = 2) in float z;\n"
            "uniform mat4 u_clip;\n"
            "void main() { gl_Position = u_clip * vec4(x, y, z, 1.0); }\n";
        const char* fragment_text =
            "#version 330 core\n"
            "out vec4 colour;\n"
            "void main() { colour = vec4(0.4, 0.6, 0.9, 1.0); }\n";
        program_ = glCreateProgram();
        add(GL_VERTEX_SHADER, vertex_text);
        add(GL_FRAGMENT_SHADER, fragment_text);
        glLinkProgram(program_);
        glBindVertexArray(vertex_array_.id());
    }

    void draw(const std::vector<std::vector<float>>& coordinates, const glm::mat4& clip,
              const RenderTarget& target) const {
        target.bind();
        glClearColor(0, 0, 0, 1);
        glClear(static_cast<GLbitfield>(GL_COLOR_BUFFER_BIT) | static_cast<GLbitfield>(GL_DEPTH_BUFFER_BIT));
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_PROGRAM_POINT_SIZE);
        glUseProgram(program_);
        glUniformMatrix4fv(glGetUniformLocation(program_, "u_clip"), 1, GL_FALSE, &clip[0][0]);
        glBindVertexArray(vertex_array_.id());
        for (GLuint c = 0; c < 3; ++c) {
            upload(buffers_[c], GL_ARRAY_BUFFER, std::span<const float>(coordinates[c]));
            float_attribute(c, 1, sizeof(float), 0);
        }
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(coordinates[0].size()));
        target.resolve();
    }

private:
    void add(GLenum kind, const char* text) const {
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }

    GLuint program_ = 0;
    VertexArray vertex_array_;
    Buffer buffers_[3];
};

/// From space to the picture, near and far planes wide apart.
glm::mat4 clip_matrix(const Camera& camera) {
    const Projection p(camera, size);
    const auto row = [&](Vec3 axis, double scale) {
        return glm::dvec4(scale * axis.x, scale * axis.y, scale * axis.z, -scale * dot(axis, p.eye()));
    };
    const double nearest = 0.01 * camera.distance, farthest = 100 * camera.distance;
    const glm::dvec4 ahead = row(p.forward(), 1);
    const double slope = (farthest + nearest) / (farthest - nearest);
    const glm::dvec4 depth = slope * ahead - glm::dvec4(0, 0, 0, 2 * farthest * nearest / (farthest - nearest));
    return glm::mat4(
        glm::transpose(glm::dmat4(row(p.right(), 1 / p.half_width()), row(p.up(), 1 / p.half_height()), depth, ahead)));
}

std::vector<std::vector<float>> arrays_of(const Frame& frame) {
    std::vector<std::vector<float>> arrays(3);
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 place = frame.positions[i];
        arrays[0].push_back(static_cast<float>(place.x));
        arrays[1].push_back(static_cast<float>(place.y));
        arrays[2].push_back(static_cast<float>(place.z));
    }
    return arrays;
}

double seconds_of(const std::function<void()>& action) {
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Times {
    double scene = INFINITY, bare = INFINITY;
};

Times measure(const Frame& frame, const Style& style, int pictures, SceneRenderer& scene, const BarePoints& bare) {
    const RenderTarget target(size);
    const Camera camera = default_camera(frame, size);
    const auto arrays = arrays_of(frame);
    const glm::mat4 clip = clip_matrix(camera);
    Times least;
    for (int i = 0; i < pictures; ++i) {
        least.scene = std::min(least.scene, seconds_of([&] {
                                   scene.draw(frame, style, camera, target);
                                   target.read();
                               }));
        least.bare = std::min(least.bare, seconds_of([&] {
                                  bare.draw(arrays, clip, target);
                                  target.read();
                              }));
    }
    return least;
}

Frame mesh_under_way(double dim) {
    RunDescription description = describe("mesh", "velocity-verlet");
    description.scene.set("dim", dim);
    Simulation simulation(description);
    simulation.advance(20);
    return simulation.frame();
}

Colouring colouring_of(const std::string& word) {
    const auto* const found = std::find(colouring_ids.begin(), colouring_ids.end(), word);
    return static_cast<Colouring>(found == colouring_ids.end() ? 0 : found - colouring_ids.begin());
}

void print(double particles, const Times& times) {
    fmt::print("{:8.0f} particles  scene {:7.1f} ms  bare points {:7.1f} ms  ratio {:.2f}\n", particles,
               1e3 * times.scene, 1e3 * times.bare, times.scene / times.bare);
}

void print_lines(double particles, const Times& times) {
    const std::string row = fmt::format("drawing-{:.0f}", particles);
    benchmark::print({row, "-", "float", particles, "steplab", 1e9 * times.scene});
    benchmark::print({row, "-", "float", particles, "bare points", 1e9 * times.bare});
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool in_lines = benchmark::wants_lines(words);
    const int pictures = words.empty() ? 7 : std::max(1, std::atoi(words[0].c_str()));
    Style style;
    if (words.size() > 1) style.colouring = colouring_of(words[1]);
    std::vector<double> dims{100, 316, 1000};
    if (words.size() > 2) dims.clear();
    for (std::size_t i = 2; i < words.size(); ++i) dims.push_back(std::atof(words[i].c_str()));
    const OffscreenContext context;
    load_opengl();
    SceneRenderer scene;
    const BarePoints bare;
    if (!in_lines) fmt::print("{}\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    for (const double dim : dims) {
        const Times times = measure(mesh_under_way(dim), style, pictures, scene, bare);
        in_lines ? print_lines(dim * dim, times) : print(dim * dim, times);
    }
}
