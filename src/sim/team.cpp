#include "sim/team.hpp"

#include "core/flush_subnormals.hpp"

namespace steplab {

Team::Team(std::size_t members) : meeting_(static_cast<std::ptrdiff_t>(members)) {
    for (std::size_t member = 1; member < members; ++member) {
        others_.emplace_back([this, member] { serve(member); });
    }
}

Team::~Team() {
    work_ = nullptr;
    meet();
}

void Team::run(const std::function<void(std::size_t)>& work) {
    const FlushSubnormals flush;
    work_ = &work;
    meet();
    work(0);
    meet();
}

void Team::serve(std::size_t member) {
    const FlushSubnormals flush;
    while (true) {
        meet();
        if (!work_) return;
        (*work_)(member);
        meet();
    }
}

}  // namespace steplab
