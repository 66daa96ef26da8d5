#include "recognition/median.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

constexpr size_t kFewValues = 16;  // fewer are left to nth_element

template <size_t N>
using Values = std::array<double, N>;

double MiddleOfThree(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

// Inlined by force: only as one run of minima and maxima do windows fit side by side into vectors.
//
// Batcher's odd-even merge of two sorted runs: the evens and the odds of both are merged, then
// neighbours put in order.
template <size_t A, size_t B>
[[gnu::always_inline]] inline Values<A + B> Merge(const Values<A>& a, const Values<B>& b) {
  if constexpr (A == 0) {
    return b;
  } else if constexpr (B == 0) {
    return a;
  } else if constexpr (A == 1 && B == 1) {
    return {std::min(a[0], b[0]), std::max(a[0], b[0])};
  } else {
    Values<(A + 1) / 2> even_a;
    Values<A / 2> odd_a;
    Values<(B + 1) / 2> even_b;
    Values<B / 2> odd_b;
    for (size_t i = 0; i < A; ++i) (i % 2 == 0 ? even_a[i / 2] : odd_a[i / 2]) = a[i];
    for (size_t i = 0; i < B; ++i) (i % 2 == 0 ? even_b[i / 2] : odd_b[i / 2]) = b[i];
    const auto evens = Merge(even_a, even_b);
    const auto odds = Merge(odd_a, odd_b);
    Values<A + B> merged;
    merged[0] = evens[0];
    if constexpr (evens.size() > odds.size()) merged[A + B - 1] = evens.back();
    if constexpr (evens.size() == odds.size()) merged[A + B - 1] = odds.back();
    for (size_t k = 0; k < odds.size() && k + 1 < evens.size(); ++k) {
      merged[2 * k + 1] = std::min(odds[k], evens[k + 1]);
      merged[2 * k + 2] = std::max(odds[k], evens[k + 1]);
    }
    return merged;
  }
}

template <size_t N>
[[gnu::always_inline]] inline Values<N> Sorted(const double* values) {
  if constexpr (N == 1) {
    return {values[0]};
  } else {
    return Merge(Sorted<N / 2>(values), Sorted<N - N / 2>(values + N / 2));
  }
}

struct Bracket {
  double low;
  double high;
  double Median(double last) const { return std::max(low, std::min(last, high)); }
};

// The middle two of 2 R values: the median of these and one more lies between them. Of two sorted
// runs of R, the smaller of the k-th and the other's k-th from the end all belong to the lower
// half.
template <size_t R>
[[gnu::always_inline]] inline Bracket MiddleTwo(const double* values) {
  const auto a = Sorted<R>(values), b = Sorted<R>(values + R);
  Bracket middle{std::min(a[0], b[R - 1]), std::max(a[0], b[R - 1])};
  for (size_t k = 1; k < R; ++k) {
    middle.low = std::max(middle.low, std::min(a[k], b[R - 1 - k]));
    middle.high = std::min(middle.high, std::max(a[k], b[R - 1 - k]));
  }
  return middle;
}

// The median of the R values to each side of `middle` and itself.
template <size_t R>
double MedianAround(const double* middle) {
  return MiddleTwo<R>(middle - R).Median(middle[R]);
}
template <>
double MedianAround<0>(const double* middle) {
  return *middle;
}

// The medians of all windows that reach R to each side, two by two; returns where it stopped.
template <size_t R>
size_t MediansWithin(std::span<const double> values, std::span<double> medians) {
  size_t i = R;
  for (; i + R + 1 < values.size(); i += 2) {
    const Bracket shared = MiddleTwo<R>(&values[i - R + 1]);
    medians[i] = shared.Median(values[i - R]);
    medians[i + 1] = shared.Median(values[i + R + 1]);
  }
  return i;
}
template <>
size_t MediansWithin<0>(std::span<const double> /*values*/, std::span<double> /*medians*/) {
  return 0;
}

// The two for each reach whose comparisons are laid out in advance.
template <size_t... R>
constexpr auto MediansAround(std::index_sequence<R...> /*reaches*/) {
  return std::array{MedianAround<R>...};
}
template <size_t... R>
constexpr auto AllMediansWithin(std::index_sequence<R...> /*reaches*/) {
  return std::array{MediansWithin<R>...};
}
constexpr auto kMedianAround = MediansAround(std::make_index_sequence<8>());
constexpr auto kMediansWithin = AllMediansWithin(std::make_index_sequence<8>());

double MedianOfLong(const double* middle, size_t reach) {
  std::vector<double> window(middle - reach, middle + reach + 1);
  const auto nth = window.begin() + static_cast<std::ptrdiff_t>(reach);
  std::nth_element(window.begin(), nth, window.end());
  return *nth;
}

}  // namespace

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  size_t count = values.size(), nth = count / 2;
  std::vector<double> others(count);
  while (count > kFewValues) {
    const double pivot = MiddleOfThree(values[0], values[count / 2], values[count - 1]);
    size_t below = 0, rest = 0;
    for (size_t i = 0; i < count; ++i) {
      const double value = values[i];
      values[below] = value;
      others[rest] = value;
      const bool is_below = value < pivot;
      below += is_below ? 1 : 0;
      rest += is_below ? 0 : 1;
    }
    if (nth < below) {
      count = below;
      continue;
    }
    values.swap(others);
    if (below == 0) break;  // the pivot is the smallest: many are equal
    nth -= below;
    count = rest;
  }
  const auto begin = values.begin(), middle = begin + static_cast<std::ptrdiff_t>(nth);
  std::nth_element(begin, middle, begin + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

void RunningMedian(std::span<const double> values, int half_width, std::span<double> medians) {
  Require(half_width >= 0, "half_width", half_width, "must not be negative");
  Require(medians.size() == values.size(), "RunningMedian needs a place for each value");
  const size_t n = values.size(), half = static_cast<size_t>(half_width);
  const auto median_at = [&](size_t i) {
    const size_t reach = std::min({half, i, n - 1 - i});
    return reach < kMedianAround.size() ? kMedianAround[reach](&values[i])
                                        : MedianOfLong(&values[i], reach);
  };
  size_t i = 0;
  for (; i < std::min(n, half); ++i) medians[i] = median_at(i);
  if (half < kMediansWithin.size() && n > 2 * half) i = kMediansWithin[half](values, medians);
  for (; i < n; ++i) medians[i] = median_at(i);
}

}  // namespace geon::recognition
