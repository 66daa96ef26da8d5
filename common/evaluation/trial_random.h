#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace geon::evaluation {

// The random numbers of trial `t` of an experiment: they depend on (seed, t) alone, so that trials
// can be made in any order, on any number of cores and hosts.
std::mt19937_64 TrialRandom(uint64_t seed, uint64_t t);

// Evenly from `low` up to `high`.
double Uniform(std::mt19937_64& random, double low, double high);

// Three draws, z first. (The arguments of a call are drawn in whatever order the compiler likes.)
Eigen::Vector3d NormalVector(std::mt19937_64& random, std::normal_distribution<double>& gauss);

}  // namespace geon::evaluation
