#include "app/window/gallery_loader.hpp"

#include "app/window/priority.hpp"
#include "core/error.hpp"
#include "io/shared_files.hpp"

#include <system_error>
#include <utility>

namespace steplab {
namespace {

ReadPicture picture_of(const ui::Exhibit& exhibit) {
    try {
        return read_png(shared_file("pictures", exhibit.id + ".png"));
    } catch (const FileError&) {
        return {};  // the scene can be opened all the same
    }
}

}  // namespace

void GalleryLoader::begin(void (*wake)()) {
    if (std::exchange(begun_, true)) return;
    const auto work = [this, wake] {
        Read result = read();
        {
            const std::lock_guard lock(mutex_);
            ready_ = std::move(result);
        }
        wake();
    };
    try {
        reading_ = std::async(std::launch::async, [work] {
            lower_priority(ThreadWork::pictures);
            work();
        });
    } catch (const std::system_error&) {
        work();  // there is no thread for it: the window waits
    }
}

GalleryLoader::Read GalleryLoader::read() {
    Read result{{ui::whole_gallery(), ui::lesson_titles()}, {}};
    for (const ui::Exhibit& exhibit : result.loaded.scenes) result.pictures.push_back(picture_of(exhibit));
    return result;
}

std::optional<GalleryLoader::Loaded> GalleryLoader::take() {
    std::optional<Read> result;
    {
        const std::lock_guard lock(mutex_);
        std::swap(result, ready_);
    }
    if (!result) return std::nullopt;
    for (std::size_t i = 0; i < result->loaded.scenes.size(); ++i) {
        const ReadPicture& picture = result->pictures[i];
        if (picture.rgba.empty()) continue;
        textures_.emplace_back().upload({picture.width, picture.height}, picture.rgba);
        result->loaded.scenes[i].picture = textures_.back().name();
    }
    return std::move(result->loaded);
}

}  // namespace steplab
