#pragma once

/// The functions of a C library that Box2D calls, correctly rounded: each returns the float that is nearest to the
/// exact result. So they give the same bits on every machine and in a browser, and what a compiler computes in advance
/// agrees. They need IEEE arithmetic, rounding to nearest, and no contraction of a·b + c.
///
/// Each computes a double first. If all numbers within its error round to the same float, that is the result; else a
/// slower computation with pairs of doubles decides.
namespace engine {

struct SineCosine {
  float sine;
  float cosine;
};

/// `x`: radians, any float. Infinity and NaN give NaN.
float correct_sine(float x);
float correct_cosine(float x);
SineCosine correct_sine_cosine(float x);

/// The angle of (x, y), −π … π, with the signs of zeros and the limits at infinity as C has them.
float correct_atan2(float y, float x);

}  // namespace engine
