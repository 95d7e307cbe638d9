#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

namespace steplab {

/// A series of samples as a view holds it.
template <class Row>
struct SampleSeriesOf {
    std::vector<Row> samples = {};
    std::shared_ptr<const int> stretch = {};  ///< since when nothing but its end has changed
};

/// Samples of a run at the multiples of a number of steps, so that the same run gives the same ones however it is
/// played. In bounded memory: when they are too many, every second one is left out, and so on from then. A row has a
/// `step`.
template <class Row>
class StepSamples {
public:
    static constexpr std::size_t most = 8192;

    /// `spacing`: steps between two samples at first.
    explicit StepSamples(std::uint64_t spacing) : spacing_(spacing) {}

    std::uint64_t spacing() const { return spacing_; }
    /// Steps from here to the next one.
    std::uint64_t to_next(std::uint64_t step) const { return spacing_ - step % spacing_; }
    bool belongs(std::uint64_t step) const { return step % spacing_ == 0; }
    /// Null: not known.
    const Row* at(std::uint64_t step) const {
        const auto place = place_of(rows_, step);
        return place != rows_.end() && place->step == step ? &*place : nullptr;
    }
    std::span<const Row> all() const { return rows_; }

    /// Adds one, or puts it in place of that of its step, unless there are to be fewer.
    void put(const Row& row) {
        if (!belongs(row.step)) return;
        const auto place = place_of(rows_, row.step);
        if (place != rows_.end()) changed();
        if (place != rows_.end() && place->step == row.step) {
            *place = row;
        } else {
            rows_.insert(place, row);
        }
        thin_out();
    }
    /// Takes away those from this step on.
    std::vector<Row> cut(std::uint64_t from) {
        const auto first = place_of(rows_, from);
        if (first == rows_.end()) return {};
        std::vector<Row> rest(first, rows_.end());
        rows_.erase(first, rows_.end());
        changed();
        return rest;
    }
    /// Puts such back.
    void append(std::span<const Row> rows) {
        for (const Row& row : rows) {
            if (belongs(row.step) && (rows_.empty() || row.step > rows_.back().step)) rows_.push_back(row);
        }
        thin_out();
    }
    /// As many as where so many steps lie between two.
    void thin_to(std::uint64_t spacing) {
        while (spacing_ < spacing) halve();
    }
    /// Calls edit(row) for each.
    template <class Edit>
    void edit(const Edit& edit) {
        std::for_each(rows_.begin(), rows_.end(), edit);
        changed();
    }
    /// Copies what is new there.
    void put_into(SampleSeriesOf<Row>& series) const {
        if (series.stretch != stretch_ || series.samples.size() > rows_.size()) {
            series = {rows_, stretch_};
            return;
        }
        const auto known = static_cast<std::ptrdiff_t>(series.samples.size());
        series.samples.insert(series.samples.end(), rows_.begin() + known, rows_.end());
    }

private:
    template <class Rows>
    static auto place_of(Rows& rows, std::uint64_t step) {
        return std::lower_bound(rows.begin(), rows.end(), step,
                                [](const Row& row, std::uint64_t wanted) { return row.step < wanted; });
    }
    void thin_out() {
        while (rows_.size() >= most) halve();
    }
    void halve() {
        spacing_ *= 2;
        std::erase_if(rows_, [this](const Row& row) { return !belongs(row.step); });
        changed();
    }
    void changed() { stretch_ = std::make_shared<const int>(); }

    std::uint64_t spacing_;
    std::vector<Row> rows_;
    std::shared_ptr<const int> stretch_ = std::make_shared<const int>();
};

/// Steps between two samples of so many particles at first: where one takes as long as some steps, there are fewer.
std::uint64_t first_spacing(std::size_t particles);

}  // namespace steplab
