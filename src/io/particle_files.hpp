#pragma once

#include "models/scene/scene.hpp"
#include "models/scene_origin.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// The files that a scene file reads, each read once, by the names that the scene file has for them.
class ParticleFiles {
public:
    /// The name for it in a scene that is written elsewhere: its own, if that leads below the folder of the scene file;
    /// else its last part.
    static std::string name_below(const std::string& name);

    enum class Use { particles, start };
    /// Gives the text of a file. Throws FileError.
    using Source = std::function<std::string(const std::string& name, Use use)>;

    explicit ParticleFiles(Source source) : source_(std::move(source)) {}
    /// Files that lie, links followed, in this folder or below it; others are refused.
    static ParticleFiles in_folder(const std::filesystem::path& folder);
    /// What a run carries of such a file: its text, uncompressed; as a start, of a trajectory or of a named step the
    /// values of that moment. Throws FileError.
    static std::string text_in(const std::filesystem::path& folder, const std::string& name, Use use);
    /// Files that a run carries with it.
    static ParticleFiles carried(std::vector<SceneFile::Part> parts);

    /// The particles of extended XYZ of any program, or of the CSV that `run` writes: of its last frame. Throws
    /// FileError.
    const ListedParticles& particles(const std::string& name);
    /// Positions and velocities of FILE or FILE:STEP: extended XYZ, CSV or a trajectory; the last frame without a step.
    std::shared_ptr<const StartingValues> start(const std::string& name);

    /// What was read.
    const std::vector<SceneFile::Part>& parts() const { return parts_; }

private:
    const std::string& text(const std::string& name, Use use);

    Source source_;
    std::vector<SceneFile::Part> parts_;
    std::map<std::string, ListedParticles> particles_;
    std::map<std::string, std::shared_ptr<const StartingValues>> starts_;
};

}  // namespace steplab
