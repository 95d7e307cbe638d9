#include "app/offscreen/module.hpp"

#include "app/offscreen/context.hpp"
#include "app/offscreen/painter.hpp"
#include "core/problem_text.hpp"
#include "render/gl.hpp"

#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <optional>

namespace steplab {
namespace {

/// Runs `action` and turns an exception into an answer.
ModuleAnswer answered(const std::function<void()>& action) noexcept {
    try {
        action();
        return {};
    } catch (const Error& error) {
        return {error.code(), problem_text(error)};
    } catch (const std::bad_alloc&) {
        return {ExitCode::usage, copy_or_short("not enough memory for the picture: choose a smaller size")};
    } catch (const std::exception& error) {
        return {ExitCode::no_opengl, problem_text(error)};
    }
}

/// A context and the painter in it, in the order of their construction.
class Module final : public OffscreenModule {
public:
    Module() { render::load_opengl(); }
    ModuleAnswer draw(const PictureRequest& request, Picture& picture) noexcept override {
        return answered([&] {
            if (!painter_) painter_.emplace();
            picture = painter_->paint(request);
        });
    }

private:
    OffscreenContext context_;
    std::optional<OffscreenPainter> painter_;
};

}  // namespace
}  // namespace steplab

extern "C" __attribute__((visibility("default"))) steplab::OffscreenModule* steplab_open_offscreen_module(
    steplab::ModuleAnswer& answer) {
    steplab::OffscreenModule* module = nullptr;
    answer = steplab::answered([&] { module = std::make_unique<steplab::Module>().release(); });
    return module;
}
