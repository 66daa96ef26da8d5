#pragma once

#include <cstdint>
#include <random>

namespace geon::evaluation {

// The random numbers of trial `t` of an experiment: they depend on (seed, t) alone, so that trials
// can be made in any order, on any number of cores and hosts.
std::mt19937_64 TrialRandom(uint64_t seed, uint64_t t);

}  // namespace geon::evaluation
