#pragma once

#include "render/gl.hpp"

#include <memory>

namespace steplab::render {

/// A mark in the commands of a context. Another context that shares its objects waits for it before it uses what the
/// commands drew, or draws over what they read.
class Fence {
public:
    /// Marks no commands: waiting for it takes no time.
    Fence() = default;
    /// After all commands of the current context so far, which are sent to the driver: they end without further ones.
    static Fence after_commands();

    /// Returns when those commands are complete. Throws GraphicsError if the driver cannot say.
    void wait() const;
    /// Commands that the current context is given from now on begin when those are complete. Does not wait itself.
    void delay_commands() const;

private:
    struct Deleter {
        void operator()(GLsync sync) const;
    };
    std::unique_ptr<__GLsync, Deleter> sync_;
};

}  // namespace steplab::render
