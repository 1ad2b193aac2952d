#include "tests/tradeoff/modes.h"

#include <algorithm>
#include <stdexcept>

namespace tradeoff {
namespace {

/// What the program is asked for, by one option, and what else it takes then.
struct Mode {
  std::string option;
  std::vector<std::string> takes;
};

/// The first one that is given counts.
const std::vector<Mode>& modes() {
  static const std::vector<Mode> all = {{"--list", {}},
                                        {"--check", {"--level", "--replay", "--accept", "--shard"}},
                                        {"--baseline", {"--accept"}},
                                        {"--report", {"--out", "--quick", "--repeats", "--shard"}},
                                        {"--validate",
                                         {"--level", "--players", "--max-error", "--budget", "--budget-p99",
                                          "--budget-most", "--budget-work", "--csv", "--shard"}},
                                        {"--promises-of", {}},
                                        {"--terms", {"--level", "--replay"}},
                                        {"--level",
                                         {"--replay", "--quick", "--repeats", "--out", "--max-error", "--budget",
                                          "--budget-p99", "--budget-most", "--budget-work", "--by-cord", "--apply"}},
                                        {"--by-cord", {"--max-error", "--shard"}},
                                        {"--scene", {"--repeats", "--out", "--csv"}}};
  return all;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_options(const std::vector<std::string>& given) {
  const auto mode =
      std::find_if(modes().begin(), modes().end(), [&](const Mode& some) { return has(given, some.option); });
  if (mode == modes().end()) return;
  for (const std::string& name : given) {
    if (name == mode->option || has(mode->takes, name)) continue;
    std::string accepted;
    for (const std::string& taken : mode->takes) accepted += (accepted.empty() ? "" : ", ") + taken;
    throw std::runtime_error(mode->option + " takes no " + name +
                             "; accepted beside it: " + (accepted.empty() ? "nothing" : accepted));
  }
}

}  // namespace tradeoff
