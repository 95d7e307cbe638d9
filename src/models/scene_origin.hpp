#pragma once

#include "models/scene/scene.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

struct Model;

/// A scene that files describe: what they hold, and the model made of it (a kind of scene whose parameters are those of
/// the file).
struct SceneFile {
    struct Part {
        std::string name;  ///< as the scene's file names it; empty for that file itself
        std::string content;
        bool operator==(const Part&) const = default;
    };
    std::vector<Part> parts;  ///< the scene's file first, then those it reads
    std::string given;        ///< what names it on a command line; no part of the content
    SceneDefaults defaults = {};
    std::shared_ptr<const Model> model;
};

/// Where a scene that is no model of the catalogue comes from: by content, wherever the files lie. Empty for a model.
class SceneOrigin {
public:
    SceneOrigin() = default;
    explicit SceneOrigin(std::shared_ptr<const SceneFile> file) : file_(std::move(file)) {}

    explicit operator bool() const { return file_ != nullptr; }
    const SceneFile& operator*() const { return *file_; }
    const SceneFile* operator->() const { return file_.get(); }

    /// Tells whether it is still there, without keeping it.
    std::weak_ptr<const SceneFile> watched() const { return file_; }

    friend bool operator==(const SceneOrigin& a, const SceneOrigin& b) {
        if (!a.file_ || !b.file_) return a.file_ == b.file_;
        return a.file_ == b.file_ || a.file_->parts == b.file_->parts;
    }

private:
    std::shared_ptr<const SceneFile> file_;
};

}  // namespace steplab
