#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "ribbon/vec2.h"

namespace fuzz {

/// Aborts the process with a message if the condition is false, so that the fuzzer reports it as a crash.
inline void demand(bool is_so, std::string_view what, std::string_view detail = {}) {
  if (is_so) return;
  std::string sentence = "not so: " + std::string(what);
  if (!detail.empty()) sentence += ": " + std::string(detail);
  std::fputs((sentence + "\n").c_str(), stderr);
  std::abort();
}

/// Checks an error message: it begins with its place, and has no control characters (they are escaped as \xNN).
inline void demand_sentence(std::string_view sentence, std::string_view begins_with) {
  demand(sentence.starts_with(begins_with), "the sentence names its file", sentence);
  demand(sentence.size() > begins_with.size() + 10 && sentence.size() < 4096, "the sentence can be read", sentence);
  for (const char c : sentence) demand(static_cast<unsigned char>(c) >= 0x20, "the sentence can be shown", sentence);
}

}  // namespace fuzz
