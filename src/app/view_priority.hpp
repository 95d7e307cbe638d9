#pragma once

namespace steplab {

/// From now on this thread, and those it starts, give way to threads that answer a person.
void give_way();

}  // namespace steplab
