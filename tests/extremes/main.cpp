#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "tests/extremes/table.h"
#include "tests/study/progress_bar.h"

int main(int argc, char** argv) {
  CLI::App app{"Where numerical stability is lost, if it is: every stepper at the limits, the worst of each figure."};
  bool full = false;
  std::string only;
  app.add_flag("--full", full, "All of each grid and a million ticks, not a part of it: an hour");
  app.add_option("--only", only, "One group: sweep, starts, drives, crush, degenerate, places, soak");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const extremes::Group& group : extremes::groups()) {
    if (!only.empty() && only != group.name) continue;
    extremes::Scope scope;
    scope.full = full;
    const std::string name(group.name);
    if (full) scope.progress = [&name](double share) { study::show_progress(name.c_str(), share); };
    const std::vector<extremes::Row> rows = group.run(scope);
    std::printf("\n%s: %s\n\n", name.c_str(), std::string(group.description).c_str());
    extremes::print_rows(rows);
  }
  return 0;
}
