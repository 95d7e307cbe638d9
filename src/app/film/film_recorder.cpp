#include "app/film/film_recorder.hpp"

#include "core/error.hpp"
#include "core/helper_thread.hpp"
#include "core/problem_text.hpp"

#include <fmt/format.h>

#include <exception>
#include <utility>

namespace steplab {

FilmRecorder::FilmRecorder(const FilmFormat& format, void (*wake)())
    : format_(format), wake_(wake), film_(make_film(format)) {
    if (!has_thread(thread_, [this] { work(); }))
        throw UsageError("a film needs a thread of its own: the system grants no further one");
}

FilmRecorder::~FilmRecorder() { finish(); }

void FilmRecorder::finish() {
    end();
    if (thread_.joinable()) thread_.join();
}

bool FilmRecorder::is_ready() const {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !ending_ && !over_;
}

void FilmRecorder::add(Picture picture, std::uint64_t frames) {
    frames_ = frames;
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Frame{std::move(picture), frames};
    }
    changed_.notify_one();
}

void FilmRecorder::end() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_one();
}

bool FilmRecorder::is_over() const {
    const std::lock_guard lock(mutex_);
    return over_;
}

std::string FilmRecorder::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void FilmRecorder::work() {
    std::string failure;
    try {
        write();
    } catch (const std::exception& error) {
        failure = failure_text(error);
    }
    {
        const std::lock_guard lock(mutex_);
        failure_ = std::move(failure);
        over_ = true;
    }
    wake_();
}

/// What is left of a film that failed; whatever made it fail may keep it from being kept, too.
std::string FilmRecorder::kept() {
    try {
        return film_->keep();
    } catch (const std::exception& error) {
        return problem_text(error);
    }
}

/// Needs no memory if there is none: an exception would end the program.
std::string FilmRecorder::failure_text(const std::exception& error) noexcept {
    try {
        return fmt::format("the film ended: {}; {}", error.what(), kept());
    } catch (const std::exception& another) {
        return problem_text(another);
    }
}

void FilmRecorder::write() {
    Picture last;
    std::uint64_t written = 0;
    while (std::optional<Frame> frame = next()) {
        for (; written > 0 && written + 1 < frame->frames; ++written) film_->add(last, true);
        last = std::move(frame->picture);
        film_->add(last, false);
        ++written;
        wake_();
    }
    film_->finish();
}

/// Waits for a picture; none once there are no more.
std::optional<FilmRecorder::Frame> FilmRecorder::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_ || ending_; });
    return std::exchange(waiting_, std::nullopt);
}

}  // namespace steplab
