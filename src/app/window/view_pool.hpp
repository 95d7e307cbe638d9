#pragma once

#include "session/session_view.hpp"

#include <memory>
#include <vector>

namespace steplab {

/// A pool of views of a session for reuse; a view that is still in use is not overwritten.
class ViewPool {
public:
    /// A view that is not in use.
    std::shared_ptr<SessionView> free_view();

private:
    std::vector<std::shared_ptr<SessionView>> views_;
};

}  // namespace steplab
