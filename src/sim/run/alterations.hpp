#pragma once

#include "models/model.hpp"
#include "models/scene/alteration.hpp"
#include "models/scene_origin.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// What a person made of single particles of a scene while it ran: part of the scene from then on. A value; empty as a
/// rule.
class Alterations {
public:
    Alterations() = default;
    /// Of a scene without any: `base`, which belongs to `origin` or to the catalogue. Of several of one particle the
    /// later ones go before.
    Alterations(const Model& base, const SceneOrigin& origin, std::vector<Alteration> all);

    bool empty() const { return !content_; }
    std::span<const Alteration> all() const;
    /// The altered scene as a model, with the parameters of the scene. Only if there are any.
    const Model& model() const;
    /// The same with more of them behind.
    std::vector<Alteration> with(std::span<const Alteration> more) const;
    /// What of a particle is altered; nothing as a rule.
    Alteration of(std::size_t particle) const;

    friend bool operator==(const Alterations& a, const Alterations& b);

private:
    struct Content;
    std::shared_ptr<const Content> content_;
};

}  // namespace steplab
