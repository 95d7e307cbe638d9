#pragma once

#include <atomic>
#include <memory>
#include <stdexcept>
#include <steplab/visibility.hpp>
#include <string>

namespace steplab {
class InterruptibleBy;
}

namespace steplab::library {

/// The base class of all exceptions that the library throws, other than std::bad_alloc. what() is one message for
/// people: what is wrong, and what would be right. Each class below has the exit code of the program `steplab`.
class STEPLAB_PUBLIC Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~Error() override;
};

/// Exit code 2: an unknown name, or a value out of range. The message names what is known, or the range.
class STEPLAB_PUBLIC UsageError : public Error {
public:
    using Error::Error;
    ~UsageError() override;
};

/// Exit code 3: a file cannot be read, written or understood. The message names file, line and reason.
class STEPLAB_PUBLIC FileError : public Error {
public:
    using Error::Error;
    ~FileError() override;
};

/// Exit code 4: the run diverged, or its method cannot meet its tolerance.
class STEPLAB_PUBLIC Diverged : public Error {
public:
    using Error::Error;
    ~Diverged() override;
};

/// Exit code 5: nothing can be drawn here.
class STEPLAB_PUBLIC GraphicsError : public Error {
public:
    using Error::Error;
    ~GraphicsError() override;
};

/// A computation was ended by an Interruption.
class STEPLAB_PUBLIC Interrupted : public Error {
public:
    using Error::Error;
    ~Interrupted() override;
};

/// While it lives, computations that this thread begins end with Interrupted within some milliseconds once `asked` is
/// true, those of their own threads too. Not to be nested.
class STEPLAB_PUBLIC Interruption {
public:
    explicit Interruption(const std::atomic<bool>& asked);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

private:
    std::unique_ptr<InterruptibleBy> here_;
};

}  // namespace steplab::library
