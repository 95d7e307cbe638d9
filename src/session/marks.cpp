#include "session/marks.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

void toggle_mark(std::vector<Mark>& marks, Mark mark) {
    const auto place = std::lower_bound(marks.begin(), marks.end(), mark,
                                        [](const Mark& a, const Mark& b) { return a.step < b.step; });
    if (place != marks.end() && place->step == mark.step) {
        marks.erase(place);
    } else {
        marks.insert(place, std::move(mark));
    }
}

}  // namespace steplab
