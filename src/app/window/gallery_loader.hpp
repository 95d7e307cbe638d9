#pragma once

#include "app/png.hpp"
#include "render/picture_texture.hpp"
#include "ui/gallery.hpp"

#include <future>
#include <mutex>
#include <optional>
#include <vector>

namespace steplab {

/// Reads the shipped scenes, all pictures and the titles of lessons for the page of scenes, on a thread of its own.
class GalleryLoader {
public:
    struct Loaded {
        ui::Gallery scenes;
        std::vector<LessonTitle> lessons;
    };

    /// Begins to read, unless it has begun; `wake` is called on the thread at the end.
    void begin(void (*wake)());
    /// What was read, its pictures as textures of the current context, once it was read; none before and afterwards.
    std::optional<Loaded> take();

private:
    struct Read {
        Loaded loaded;
        std::vector<ReadPicture> pictures;  ///< of each exhibit; without pixels where it has none
    };
    static Read read();

    std::vector<render::PictureTexture> textures_;
    bool begun_ = false;
    std::mutex mutex_;
    std::optional<Read> ready_;
    std::future<void> reading_;
};

}  // namespace steplab
