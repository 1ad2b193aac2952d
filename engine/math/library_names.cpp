#include "engine/math/float_functions.h"

/// The names that Box2D calls, of the functions of float_functions.h. A program that has this object binds the calls of
/// Box2D's shared library to them too, for the dynamic linker looks in the program first.
extern "C" {

float sinf(float x) noexcept;
float cosf(float x) noexcept;
void sincosf(float x, float* sine, float* cosine) noexcept;
float atan2f(float y, float x) noexcept;

float sinf(float x) noexcept { return engine::correct_sine(x); }

float cosf(float x) noexcept { return engine::correct_cosine(x); }

void sincosf(float x, float* sine, float* cosine) noexcept {
  const engine::SineCosine both = engine::correct_sine_cosine(x);
  *sine = both.sine;
  *cosine = both.cosine;
}

float atan2f(float y, float x) noexcept { return engine::correct_atan2(y, x); }

}  // extern "C"
