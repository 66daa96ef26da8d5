#pragma once

#include <cstdint>
#include <random>

namespace geon::evaluation {

// The random numbers of trial `t` of an experiment: they depend on (seed, t) alone, so that trials
// can be made in any order, on any number of cores and hosts.
std::mt19937_64 TrialRandom(uint64_t seed, uint64_t t);

// Evenly from `low` up to `high`.
double Uniform(std::mt19937_64& random, double low, double high);

}  // namespace geon::evaluation
