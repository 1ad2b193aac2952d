#pragma once

#include <cstdint>

namespace game {

/// A number 0 … 1 that looks random, the same for the same arguments everywhere.
double scatter(int x, int y, int seed);

/// Smooth noise 0 … 1 that comes again after `period` (whole numbers) in x and y; about one hill a unit.
double tiled_noise(double x, double y, int period, int seed);

/// The same with finer and finer detail, four octaves, 0 … 1.
double tiled_cloudiness(double x, double y, int period, int seed);

}  // namespace game
