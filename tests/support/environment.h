#pragma once

#include <cstdlib>
#include <string>

namespace test_support {

/// An environment variable, set (or, for null, taken away) until the end of the scope.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* const old = std::getenv(name)) old_ = old, was_set_ = true;
    set(value);
  }
  ~Environment() { set(was_set_ ? old_.c_str() : nullptr); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  void set(const char* value) const { value != nullptr ? setenv(name_, value, 1) : unsetenv(name_); }
  const char* name_;
  std::string old_;
  bool was_set_ = false;
};

}  // namespace test_support
