#include "app/window/scene_files.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "io/output_file.hpp"
#include "io/scene_export.hpp"
#include "io/scene_file.hpp"
#include "io/starting_values_file.hpp"
#include "io/trajectory_format.hpp"
#include "io/trajectory_reader.hpp"
#include "session/session_file.hpp"
#include "ui/plot/plot_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace steplab {
namespace {

// How often a file is looked at: one system call each time.
constexpr std::chrono::milliseconds between_looks{500};

constexpr const char* no_memory = "there is not enough memory for this scene";

std::string in_own_folder(const std::string& path) {
    const char* const home = std::getenv("HOME");
    return home && path.starts_with("~/") ? home + path.substr(1) : path;
}

/// The file of a scene and those that it reads, which lie in its folder.
std::vector<std::filesystem::path> files_of(const SceneFile& scene) {
    const std::filesystem::path file = scene_path(scene.given);
    std::vector<std::filesystem::path> files{file};
    for (const SceneFile::Part& part : scene.parts) {
        if (part.name.empty()) continue;
        const std::filesystem::path named = file.parent_path() / part.name;
        std::error_code error;
        const bool with_step = !std::filesystem::exists(named, error);  // "run.trajectory:500"
        files.push_back(with_step ? file.parent_path() / file_at_step(part.name).file : named);
    }
    return files;
}

/// Sessions and lessons begin with the version of their format, after comments at most.
bool begins_with(const InputFile& file, std::string_view key) {
    std::istringstream head(file.read(0, 4096));
    std::string line;
    while (std::getline(head, line) && (line.empty() || line.starts_with('#'))) {
    }
    return line.starts_with(key);
}

bool is_row_file(const std::string& name) {
    try {
        trajectory_format_of(name);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

/// The window's time goes forward.
RunDescription forward(RunDescription scene) {
    if (scene.dt < 0)
        throw UsageError(
            fmt::format("the scene runs backward in time, dt = {}: the window takes a dt > 0", exact_text(scene.dt)));
    return scene;
}

/// By what is in it, whatever it is called.
SceneFiles::News opened(const std::string& name) {
    using Kind = SceneFiles::News::Kind;
    std::error_code none;
    if (!std::filesystem::is_regular_file(name, none))
        return {.kind = Kind::opened, .scene = forward(describe(find_scene(name)))};
    if (InputFile file(name); TrajectoryReader::reads(file)) {
        TrajectoryReader(std::move(file)).run();  // one that is damaged at its beginning is refused
        return {.kind = Kind::trajectory, .text = name};
    } else if (begins_with(file, "steplab-session")) {
        return {.kind = Kind::session, .session = read_session_file(name)};
    } else if (begins_with(file, "steplab-lesson")) {
        return {.kind = Kind::lesson, .lesson = read_lesson_file(name)};
    } else if (is_row_file(name)) {
        return {.kind = Kind::trajectory, .text = name};
    }
    return {.kind = Kind::opened, .scene = forward(describe(find_scene(name)))};
}

}  // namespace

SceneFiles::SceneFiles(void (*wake)()) : wake_(wake) {
    thread_ = std::thread([this] { work(); });
}

SceneFiles::~SceneFiles() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void SceneFiles::open(const std::string& name) {
    post([this, name = in_own_folder(name)] { report_read(opened(name)); });
}

void SceneFiles::open_lesson(const std::string& name) {
    post([this, name] { report_read({.kind = News::Kind::lesson, .lesson = find_lesson(name)}); });
}

void SceneFiles::save(const RunDescription& run, const SceneView& view) {
    post([this, run, view] {
        const std::string name = ui::free_name({}, run.model, "toml");
        write_scene(name, run, view);
        report({.kind = News::Kind::saved, .text = name});
    });
}

void SceneFiles::save_session(std::shared_future<Recording> recording) {
    post([this, recording = std::move(recording)] { write_new("session", "session", session_text(recording.get())); });
}

void SceneFiles::finish_session(std::shared_ptr<OutputFile> file, std::shared_future<Recording> recording) {
    post([this, file = std::move(file), recording = std::move(recording)] {
        file->write(session_text(recording.get()));
        file->commit();
        report({.kind = News::Kind::saved, .text = file->name()});
    });
}

void SceneFiles::write_new(std::string_view name, std::string_view end, const std::string& text) {
    const std::string path = ui::free_name({}, name, end);
    OutputFile file(path);
    file.write(text);
    file.commit();
    report({.kind = News::Kind::saved, .text = path});
}

void SceneFiles::watch(const RunDescription& shown) {
    post([this, origin = shown.origin] {
        const bool other = !watching_ || !origin || watched_->given != origin->given;
        watched_ = origin;
        watching_ = static_cast<bool>(origin);
        if (!other || !watching_) return;
        failed_ = false;
        watch_files();
    });
}

std::optional<SceneFiles::News> SceneFiles::take() {
    const std::lock_guard lock(mutex_);
    if (std::exchange(without_memory_, false)) return News{.text = std::string(no_memory)};
    if (news_.empty()) return std::nullopt;
    News next = std::move(news_.front());
    news_.pop_front();
    return next;
}

void SceneFiles::post(Job job) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
}

void SceneFiles::work() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        if (!jobs_.empty()) {
            const Job job = std::move(jobs_.front());
            jobs_.pop_front();
            lock.unlock();
            attempt(job);
            lock.lock();
        } else if (!watching_) {
            changed_.wait(lock);
        } else if (changed_.wait_for(lock, between_looks) == std::cv_status::timeout) {
            lock.unlock();
            attempt([this] {
                if (files_.changed()) read_again();
            });
            lock.lock();
        }
    }
}

/// Reads once more, because they may have changed before they were watched.
void SceneFiles::watch_files() {
    watched_files_ = files_of(*watched_);
    files_ = FileWatch(watched_files_);
    read_again();
}

/// What was wrong is over when the file is right again, even if it then is as it was.
void SceneFiles::read_again() {
    const bool failed = std::exchange(failed_, true);
    attempt([&] {
        const SceneOrigin fresh = find_scene(watched_->given);
        const RunDescription scene = forward(describe(fresh));
        failed_ = false;
        if (!failed && fresh == watched_) return;
        watched_ = fresh;
        report_read({.kind = News::Kind::read_again, .scene = scene});
        if (files_of(*fresh) != watched_files_) watch_files();
    });
}

/// Scenes that were read before are not kept twice.
void SceneFiles::report_read(News news) {
    if (news.scene) scenes_.share(*news.scene);
    if (news.session) scenes_.share(*news.session);
    if (news.lesson) {
        Recording session = *news.lesson->session;
        scenes_.share(session);
        news.lesson->session = std::make_shared<const Recording>(std::move(session));
    }
    report(std::move(news));
}

void SceneFiles::report(News news) {
    {
        const std::lock_guard lock(mutex_);
        news_.push_back(std::move(news));
    }
    wake_();
}

template <class Work>
void SceneFiles::attempt(const Work& work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        fail(no_memory);
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

/// On the thread, where an exception would end the program: without memory for the news, take() makes them.
void SceneFiles::fail(const char* message) noexcept {
    try {
        report({.kind = News::Kind::failed, .text = message});
    } catch (const std::exception&) {
        {
            const std::lock_guard lock(mutex_);
            without_memory_ = true;
        }
        wake_();
    }
}

}  // namespace steplab
