#include "rangefinder/stripe_runs.h"

#include <bit>
#include <opencv2/core/hal/intrin.hpp>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

constexpr int kWord = 64;

int Reaching(const cv::v_uint8x16& pixels, const cv::v_uint8x16& level) {
  return cv::v_signmask(cv::v_max(pixels, level) == pixels);
}

// Bit k: pixel k of 16 reaches the level.
uint64_t Bits16(const uint8_t* pixels, const cv::v_uint8x16& level) {
  return static_cast<uint64_t>(Reaching(cv::v_load(pixels), level));
}

// One row as bits.
class BitRow {
 public:
  BitRow(int width_px, uint8_t level_1)
      : width_px_(width_px),
        level_1_(level_1),
        words_(static_cast<size_t>((width_px + kWord - 1) / kWord), 0) {}

  void Read(const uint8_t* row) {
    uint64_t any = 0;
    const cv::v_uint8x16 level = cv::v_setall_u8(level_1_);
    const int whole = width_px_ / kWord;
    for (int w = 0; w < whole; ++w) {
      const uint8_t* p = row + static_cast<ptrdiff_t>(w) * kWord;
      const cv::v_uint8x16 brightest = cv::v_max(cv::v_max(cv::v_load(p), cv::v_load(p + 16)),
                                                 cv::v_max(cv::v_load(p + 32), cv::v_load(p + 48)));
      uint64_t word = 0;
      if (Reaching(brightest, level) != 0) {
        word = Bits16(p, level) | Bits16(p + 16, level) << 16 | Bits16(p + 32, level) << 32 |
               Bits16(p + 48, level) << 48;
      }
      words_[static_cast<size_t>(w)] = word;
      any |= word;
    }
    if (whole * kWord < width_px_) {
      uint64_t word = 0;
      for (int u = whole * kWord; u < width_px_; ++u) {
        word |= static_cast<uint64_t>(row[u] >= level_1_) << (u % kWord);
      }
      words_.back() = word;
      any |= word;
    }
    is_dark_ = any == 0;
  }
  bool is_dark() const { return is_dark_; }  // no pixel reaches the level
  size_t size() const { return words_.size(); }
  uint64_t operator[](size_t w) const { return words_[w]; }

 private:
  int width_px_;
  uint8_t level_1_;
  std::vector<uint64_t> words_;
  bool is_dark_ = true;
};

// Calls visit(index of bit) for every 1.
template <typename Visit>
void ForEachBit(uint64_t word, size_t w, Visit visit) {
  for (; word != 0; word &= word - 1) {
    visit(static_cast<int>(w) * kWord + std::countr_zero(word));
  }
}

bool Continues(const Run& run, int line, int first) {
  return run.line == line && first <= run.last + 2;
}

// Down the rows; a column's run begins and ends where a bit differs from the one above.
std::vector<Run> RunsOfColumns(const sensor::Image& gray, uint8_t level_1) {
  const auto columns = static_cast<size_t>(gray.width_px);
  std::vector<Run> found;  // in the order of their ends
  found.reserve(columns + columns / 2);
  std::vector<int> first(columns, 0);
  std::vector<int> latest(columns, -1);  // of each column, its index in `found`
  std::vector<size_t> end_of_column(columns + 1, 0);
  const auto emit = [&](int u, int last) {
    const auto column = static_cast<size_t>(u);
    if (latest[column] >= 0 &&
        Continues(found[static_cast<size_t>(latest[column])], u, first[column])) {
      found[static_cast<size_t>(latest[column])].last = last;
      return;
    }
    latest[column] = static_cast<int>(found.size());
    found.push_back({u, first[column], last});
    ++end_of_column[column + 1];
  };
  BitRow row(gray.width_px, level_1);
  BitRow above(gray.width_px, level_1);
  for (int v = 0; v < gray.height_px; ++v) {
    row.Read(gray.data.data() + static_cast<ptrdiff_t>(v) * gray.row_stride_bytes);
    if (row.is_dark() && above.is_dark()) continue;
    for (size_t w = 0; w < row.size(); ++w) {
      ForEachBit(row[w] & ~above[w], w, [&](int u) { first[static_cast<size_t>(u)] = v; });
      ForEachBit(above[w] & ~row[w], w, [&](int u) { emit(u, v - 1); });
    }
    std::swap(row, above);
  }
  for (size_t w = 0; w < above.size(); ++w) {
    ForEachBit(above[w], w, [&](int u) { emit(u, gray.height_px - 1); });
  }
  // By column: each column's runs follow those of the columns before it.
  for (size_t u = 0; u < columns; ++u) end_of_column[u + 1] += end_of_column[u];
  std::vector<Run> sorted(found.size());
  for (const Run& run : found) sorted[end_of_column[static_cast<size_t>(run.line)]++] = run;
  return sorted;
}

// Along the rows; a run begins and ends where a bit differs from the one before.
std::vector<Run> RunsOfRows(const sensor::Image& gray, uint8_t level_1) {
  std::vector<Run> runs;
  runs.reserve(static_cast<size_t>(gray.height_px) * 3 / 2);
  BitRow row(gray.width_px, level_1);
  for (int v = 0; v < gray.height_px; ++v) {
    row.Read(gray.data.data() + static_cast<ptrdiff_t>(v) * gray.row_stride_bytes);
    uint64_t before = 0;
    int first = 0;
    const auto emit = [&](int last) {
      if (!runs.empty() && Continues(runs.back(), v, first)) {
        runs.back().last = last;
      } else {
        runs.push_back({v, first, last});
      }
    };
    for (size_t w = 0; w < row.size(); ++w) {
      const uint64_t changes = row[w] ^ (row[w] << 1 | before);
      before = row[w] >> (kWord - 1);
      ForEachBit(changes, w, [&](int u) {
        const bool begins = (row[w] >> (u % kWord) & 1U) != 0;
        if (begins) {
          first = u;
        } else {
          emit(u - 1);
        }
      });
    }
    if (before != 0) emit(gray.width_px - 1);  // the row is whole words, the last bit 1
  }
  return runs;
}

}  // namespace

LineView::LineView(const sensor::Image& gray, sensor::Laser laser) : data(gray.data.data()) {
  const bool horizontal = laser == sensor::Laser::kHorizontal;
  lines = horizontal ? gray.width_px : gray.height_px;
  length = horizontal ? gray.height_px : gray.width_px;
  line_step = horizontal ? 1 : gray.row_stride_bytes;
  pixel_step = horizontal ? gray.row_stride_bytes : 1;
}

std::vector<Run> FindRuns(const sensor::Image& gray, sensor::Laser laser, uint8_t level_1) {
  Require(level_1 > 0, "FindRuns: every pixel reaches level 0");
  return laser == sensor::Laser::kHorizontal ? RunsOfColumns(gray, level_1)
                                             : RunsOfRows(gray, level_1);
}

}  // namespace geon::rangefinder
