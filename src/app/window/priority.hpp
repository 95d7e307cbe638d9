#pragma once

#include <vector>

namespace steplab {

/// From now on this thread, and those it starts, give way to threads that answer a person.
void give_way();

/// While it lives, notes which threads of the program are new: at its end these give way too. For the threads that an
/// OpenGL driver without a graphics card starts to draw with.
class NewThreadsGiveWay {
public:
    NewThreadsGiveWay();
    ~NewThreadsGiveWay();
    NewThreadsGiveWay(const NewThreadsGiveWay&) = delete;
    NewThreadsGiveWay& operator=(const NewThreadsGiveWay&) = delete;

private:
    std::vector<int> before_;
};

}  // namespace steplab
