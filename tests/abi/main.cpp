// A user's program with other compiler flags and its own use of Eigen, linked with the libraries as they are built
// here. The layout of all types at the interface must agree, and the cords must have the same bits.

#include <Eigen/Dense>
#include <cstdio>
#include <string>

#include "ribbon/box2d/state_hash.h"
#include "tests/bits/bit_scenes.h"

int main() {
#if defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2")) return 77;  // skipped
#endif
  // Its own alignment and vector code do take effect.
  Eigen::Matrix4d own = Eigen::Matrix4d::Identity();
  std::printf("Eigen aligns %zu bytes, trace %g\n", alignof(Eigen::Matrix4d), own.trace());
  int different = 0;
  for (const bits::BitScene& scene : bits::bit_scenes()) {
    const std::uint64_t hash = bits::hash_of_run(scene);
    const bool same = hash == scene.golden;
    different += same ? 0 : 1;
    std::printf("%s: %s, %s\n", std::string(scene.name).c_str(), ribbon::box2d::to_hex(hash).c_str(),
                same ? "same" : ("golden " + ribbon::box2d::to_hex(scene.golden)).c_str());
  }
  return different == 0 ? 0 : 1;
}
