#include "evaluation/trial_random.h"

namespace geon::evaluation {
namespace {

// Finaliser of splitmix64: neighbouring numbers become unrelated ones.
uint64_t Mix(uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace

std::mt19937_64 TrialRandom(uint64_t seed, uint64_t t) {
  return std::mt19937_64(Mix(Mix(seed) + t));
}

double Uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector3d NormalVector(std::mt19937_64& random, std::normal_distribution<double>& gauss) {
  Eigen::Vector3d vector;
  for (int axis = 2; axis >= 0; --axis) vector[axis] = gauss(random);
  return vector;
}

}  // namespace geon::evaluation
