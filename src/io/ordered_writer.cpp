#include "io/ordered_writer.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace steplab {

OrderedWriter::OrderedWriter(OutputFile& file) : file_(file) {
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1U, 16U);
    for (unsigned i = 0; i < count; ++i) {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
}

OrderedWriter::~OrderedWriter() = default;  // the threads are asked to stop and joined; blocks not written are dropped

void OrderedWriter::work(const std::stop_token& stop) {
    while (true) {
        std::unique_lock lock(mutex_);
        if (!ready_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
        auto task = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        task();
    }
}

void OrderedWriter::submit(Block block) {
    std::packaged_task<std::string()> task(std::move(block));
    under_way_.push_back(task.get_future());
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(task));
    }
    ready_.notify_one();
    const auto oldest_is_made = [this] {
        return under_way_.front().wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    const std::size_t most = 2 * threads_.size() + 1;
    while (!under_way_.empty() && (under_way_.size() > most || oldest_is_made())) write_oldest();
}

void OrderedWriter::drain() {
    while (!under_way_.empty()) write_oldest();
}

void OrderedWriter::write_oldest() {
    const std::string text = under_way_.front().get();
    under_way_.pop_front();
    file_.write(text);
}

}  // namespace steplab
