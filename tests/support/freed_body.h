#pragma once

#include <box2d/b2_body.h>
#include <gtest/gtest.h>

#include <vector>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#endif

namespace test_support {

/// Watches the memory of a destroyed body during its lifetime. (The world reuses that memory for the next body.) The
/// test fails if anything writes there, and with the address sanitizer if anything reads there.
class FreedBody {
 public:
  explicit FreedBody(const b2Body* body) : body_(body), before_(bytes()) {
#ifdef __SANITIZE_ADDRESS__
    ASAN_POISON_MEMORY_REGION(body_, sizeof(b2Body));
#endif
  }
  FreedBody(const FreedBody&) = delete;
  FreedBody& operator=(const FreedBody&) = delete;
  ~FreedBody() {
#ifdef __SANITIZE_ADDRESS__
    ASAN_UNPOISON_MEMORY_REGION(body_, sizeof(b2Body));
#endif
    EXPECT_EQ(bytes(), before_) << "something was written where a body was";
  }

 private:
  std::vector<unsigned char> bytes() const {
    const auto* first = reinterpret_cast<const unsigned char*>(body_);
    return {first, first + sizeof(b2Body)};
  }

  const b2Body* body_;
  std::vector<unsigned char> before_;
};

}  // namespace test_support
