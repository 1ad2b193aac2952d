#pragma once

/// Functions of sound that give the same bits on every machine: they call no library sine.
namespace engine {

/// Returns sin(2π·turns).
double sine(double turns);
/// Returns a smooth step: 0 below 0, 1 above 1.
double smooth_step(double x);

}  // namespace engine
