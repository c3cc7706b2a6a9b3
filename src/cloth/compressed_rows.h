// Rows of different lengths, stored contiguously.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace drench {

// Compressed sparse rows: lists of different lengths, such as the neighbours of each node, in two arrays.
template <typename Value>
class CompressedRows {
  public:
    class Row {
      public:
        Row(const Value* begin, const Value* end) : begin_(begin), end_(end) {}
        const Value* begin() const { return begin_; }
        const Value* end() const { return end_; }
        std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
        const Value& operator[](std::size_t i) const { return begin_[i]; }

      private:
        const Value* begin_;
        const Value* end_;
    };

    CompressedRows() = default;

    // @param rows     number of rows
    // @param forEach  must call the function `add(row, value)`, its argument, for every value. It is called
    //     twice, to count and to fill, and must do the same both times. The values of a row keep this order
    template <typename ForEach>
    CompressedRows(std::size_t rows, ForEach forEach) : first_(rows + 1, 0) {
        forEach([&](std::size_t row, const Value&) { ++first_[row + 1]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        values_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        forEach([&](std::size_t row, const Value& value) { values_[next[row]++] = value; });
    }

    // Number of rows.
    std::size_t size() const { return first_.size() - 1; }
    Row operator[](std::size_t row) const {
        return {values_.data() + first_[row], values_.data() + first_[row + 1]};
    }
    // Number of values in all rows.
    std::size_t valueCount() const { return values_.size(); }

  private:
    std::vector<std::size_t> first_ = {0};  // index of the first value of each row, and the total
    std::vector<Value> values_;
};

}  // namespace drench
