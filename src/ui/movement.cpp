#include "ui/movement.hpp"

namespace steplab::ui {

void Movement::seen(Time now) {
    seen_ = now;
    awaits_picture_ = true;
}

void Movement::requested(Time now, bool another) {
    if (now == seen_ && !another) awaits_picture_ = false;  // what is dragged stands still: nothing new will come
}

void Movement::pictured(Time requested, bool coarse, Time now) {
    if (!awaits_picture_ || requested < seen_) return;
    awaits_picture_ = false;
    if (coarse) seen_ = now;  // for the next movement, however long this picture took
}

}  // namespace steplab::ui
