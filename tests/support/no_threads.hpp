#pragma once

#include <cstddef>
#include <pthread.h>
#include <stdexcept>

namespace steplab::test {

/// While it lives, no thread can be started: each would get a stack that no machine has the memory for.
class NoThreads {
public:
    NoThreads() {
        pthread_attr_t attributes;
        pthread_getattr_default_np(&attributes);
        pthread_attr_getstacksize(&attributes, &usual_);
        set(std::size_t{1} << 50);
    }
    ~NoThreads() { set(usual_); }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    static void set(std::size_t bytes) {
        pthread_attr_t attributes;
        pthread_getattr_default_np(&attributes);
        pthread_attr_setstacksize(&attributes, bytes);
        pthread_setattr_default_np(&attributes);
        pthread_attr_destroy(&attributes);
    }

    std::size_t usual_ = 0;
};

}  // namespace steplab::test
