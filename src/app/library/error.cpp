#include "core/error.hpp"

#include "app/library/implementation.hpp"
#include "core/interruption.hpp"
#include "io/commit.hpp"

#include <filesystem>
#include <new>
#include <steplab/version.hpp>
#include <system_error>

namespace steplab::library {

Error::~Error() = default;
UsageError::~UsageError() = default;
FileError::~FileError() = default;
Diverged::~Diverged() = default;
GraphicsError::~GraphicsError() = default;
Interrupted::~Interrupted() = default;

namespace {

[[noreturn]] void throw_own(ExitCode code, const std::string& message) {
    switch (code) {
        case ExitCode::file:
            throw FileError(message);
        case ExitCode::diverged:
            throw Diverged(message);
        case ExitCode::no_opengl:
            throw GraphicsError(message);
        default:
            throw UsageError(message);
    }
}

}  // namespace

void rethrow_as_own() {
    try {
        throw;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const steplab::Error& error) {
        throw_own(error.code(), error.what());
    } catch (const steplab::Interrupted&) {
        throw Interrupted("the computation was interrupted");
    } catch (const std::filesystem::filesystem_error& error) {
        throw FileError(error.what());
    } catch (const std::system_error& error) {
        throw UsageError(std::string("the system grants no more threads or memory: ") + error.what());
    }
}

Interruption::Interruption(const std::atomic<bool>& asked) : here_(std::make_unique<InterruptibleBy>(asked)) {}
Interruption::~Interruption() = default;

std::string_view version() { return STEPLAB_VERSION; }

}  // namespace steplab::library
