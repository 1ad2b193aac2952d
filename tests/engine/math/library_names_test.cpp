#include <box2d/box2d.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "engine/math/float_functions.h"

namespace engine {
namespace {

using Function = float(float);

/// Returns a function of the C library itself, which the program has under the
/// same name.
Function* function_of_library(const char* name) {
  void* const library = dlopen("libm.so.6", RTLD_NOW | RTLD_LOCAL);
  return library == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(library, name));
}

/// Returns an angle whose sine the C library does not round correctly; 0 if
/// there is none among a million.
float angle_that_differs(Function* library_sine) {
  for (int k = 1; k < 1000000; ++k) {
    const float angle = 1e-6F * static_cast<float>(k);
    if (library_sine(angle) != correct_sine(angle)) return angle;
  }
  return 0.0F;
}

// b2Rot::Set of a header runs in this program; that of a body's constructor in
// Box2D's shared library.
TEST(LibraryNames, Box2DGetsTheSinesOfTheProgram) {
  Function* const library_sine = function_of_library("sinf");
  if (library_sine == nullptr) GTEST_SKIP() << "this C library is not glibc";
  const float angle = angle_that_differs(library_sine);
  if (angle == 0.0F) GTEST_SKIP() << "the sines of this C library are correct";
  b2World world({0.0F, 0.0F});
  b2BodyDef def;
  def.angle = angle;
  EXPECT_EQ(world.CreateBody(&def)->GetTransform().q.s, correct_sine(angle));
  EXPECT_EQ(b2Rot(angle).s, correct_sine(angle));
}

}  // namespace
}  // namespace engine
