#pragma once

#include <cstdint>

namespace game {

/// Returns a pseudo-random number 0 … 1, a function of the arguments on all machines.
double scatter(int x, int y, int seed);

/// Returns smooth noise 0 … 1 with the period `period` in x and y and about one hill per unit.
double tiled_noise(double x, double y, int period, int seed);

/// Returns the sum of four octaves of tiled_noise, 0 … 1.
double tiled_cloudiness(double x, double y, int period, int seed);

}  // namespace game
