#pragma once

#include "core/shape.hpp"
#include "render/camera.hpp"
#include "sim/run/run_description.hpp"
#include "ui/context.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace steplab::ui {

/// A setting that a scene's file may choose: for as long as the scene is shown, unless the user changes it meanwhile.
template <class T>
class SceneChoice {
public:
    /// Another scene is shown, which chooses this or nothing. `already`: the setting may have been made before, and
    /// the user's own is the `usual` one.
    void follow(T& setting, std::optional<T> chosen, bool already, T usual) {
        if (before_ && setting == chosen_) setting = *before_;
        before_.reset();
        if (!chosen || (already && setting != *chosen)) return;
        before_ = already ? usual : setting;
        setting = chosen_ = *chosen;
    }
    /// The setting as the user has it, without what a scene chose.
    T own(T setting) const { return before_ && setting == chosen_ ? *before_ : setting; }

private:
    T chosen_{};
    std::optional<T> before_;  ///< what the setting goes back to
};

/// Keeps the camera, the colours and the followed particle suited to the scene: a new scene is shown whole, or as its
/// file says, with one particle followed. A camera that the user has moved stays until another scene is shown; it stays
/// in any case where a scene's file is read again.
class ViewKeeper {
public:
    void keep(const Context& context);
    /// What the user chose, where the file of a scene has chosen something else.
    render::Colouring own(render::Colouring shown) const { return colouring_.own(shown); }
    render::Background own(render::Background shown) const { return background_.own(shown); }

private:
    void place_camera(const Context& context, bool first, bool other_scene, bool other_shape);
    void choose_colours(const Context& context, bool first);

    std::string scene_;  ///< id_of() the run
    SceneOrigin origin_;
    std::shared_ptr<const Shape> shape_;
    PixelRect place_;
    std::optional<render::Camera> home_;  ///< where the camera was last placed by the program
    SceneChoice<render::Colouring> colouring_;
    SceneChoice<render::Background> background_;
};

}  // namespace steplab::ui
