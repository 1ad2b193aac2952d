#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/extremes/table.h"
#include "tests/study/progress_bar.h"

/// Returns 0 if all required rows pass, 1 if one fails, 2 for a bad argument.
int main(int argc, char** argv) {
  CLI::App app{
      "Limits of stability: every solver in extreme cases, and the worst value of each figure. `ok` is within "
      "its "
      "limit; `FAIL` is not and has to be; `lost` is not, and known: of the thesis's method."};
  bool full = false;
  std::string only;
  std::string part;
  std::vector<std::string> names;
  for (const extremes::Group& group : extremes::groups()) names.emplace_back(group.name);
  app.add_flag("--full", full, "All of each grid and a million ticks, not a part of it: hours");
  app.add_option("--only", only, "One group")->check(CLI::IsMember(names));
  app.add_option("--case", part, "Only cases that have this in what stands under `worst at`");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bool good = true;
  for (const extremes::Group& group : extremes::groups()) {
    if (!only.empty() && only != group.name) continue;
    const std::string name(group.name);
    extremes::Scope scope;
    scope.full = full;
    scope.part = part;
    if (full) scope.progress = [&name](double share) { study::show_progress(name.c_str(), share); };
    const std::vector<extremes::Row> rows = group.run(scope);
    std::printf("%s: %s\n\n", name.c_str(), std::string(group.description).c_str());
    extremes::print_rows(rows);
    std::printf("\n");
    std::fflush(stdout);
    good = good && std::all_of(rows.begin(), rows.end(),
                               [](const extremes::Row& row) { return row.passed() || !row.is_required(); });
  }
  return good ? 0 : 1;
}
