#include "tests/study/progress_bar.h"

#include <cstdio>
#include <string>

namespace study {

void show_progress(const char* what, double share, std::optional<double> seconds_left) {
  constexpr int width = 40;
  const int full = static_cast<int>(share * width);
  std::fprintf(stderr, "\r%-7s [%s%s] %3.0f %%", what, std::string(static_cast<std::size_t>(full), '#').c_str(),
               std::string(static_cast<std::size_t>(width - full), '.').c_str(), 100.0 * share);
  if (seconds_left) std::fprintf(stderr, ", %.0f s left  ", *seconds_left);
  if (share >= 1.0) std::fputc('\n', stderr);
}

}  // namespace study
