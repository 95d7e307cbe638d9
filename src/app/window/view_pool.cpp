#include "app/window/view_pool.hpp"

#include <algorithm>

namespace steplab {

std::shared_ptr<SessionView> ViewPool::free_view() {
    const auto unused = [](const std::shared_ptr<SessionView>& view) { return view.use_count() == 1; };
    const auto found = std::find_if(views_.begin(), views_.end(), unused);
    return found != views_.end() ? *found : views_.emplace_back(std::make_shared<SessionView>());
}

}  // namespace steplab
