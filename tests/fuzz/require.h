#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "ribbon/vec2.h"

namespace fuzz {

/// Aborts the process with a message if the condition is false, so that the fuzzer reports it as a crash.
inline void require(bool condition, std::string_view what, std::string_view detail = {}) {
  if (condition) return;
  std::string sentence = "violated: " + std::string(what);
  if (!detail.empty()) sentence += ": " + std::string(detail);
  std::fputs((sentence + "\n").c_str(), stderr);
  std::abort();
}

/// Checks an error message: it begins with its place, and has no control characters (they are escaped as \xNN).
inline void require_message(std::string_view sentence, std::string_view begins_with) {
  require(sentence.starts_with(begins_with), "the message names its file", sentence);
  require(sentence.size() > begins_with.size() + 10 && sentence.size() < 4096, "the message has a readable length",
          sentence);
  for (const char c : sentence)
    require(static_cast<unsigned char>(c) >= 0x20, "the message has no control characters", sentence);
}

}  // namespace fuzz
