#pragma once

namespace geon::evaluation {

// How often something came out right.
struct SuccessRate {
  int right = 0;
  int n = 0;
  void Count(bool is_right) {
    ++n;
    if (is_right) ++right;
  }
  double value_1() const { return n > 0 ? static_cast<double>(right) / n : 0.0; }
};

struct Interval {
  double low_1 = 0.0;
  double high_1 = 1.0;
};

// The 95 % interval of the true rate. Source: Wilson 1927, "Probable inference, the law of
// succession, and statistical inference": unlike rate +- 2 sigma it stays within 0 and 1 and means
// something when nothing (or everything) went wrong. Without trials: 0 to 1.
Interval WilsonInterval(const SuccessRate& rate);
// The same of a share that `n_1` independent trials would tell as well; neither need be whole.
Interval WilsonInterval(double share_1, double n_1);

}  // namespace geon::evaluation
