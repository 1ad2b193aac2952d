#include "tests/extremes/any_scene/runs.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

namespace any_scene {
namespace {

using Clock = std::chrono::steady_clock;

/// A process that plays one scene and writes its summary into a pipe.
struct Child {
  SceneId which;
  pid_t process = 0;
  int pipe = 0;
  Clock::time_point begun;
};

void write_all(int file, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t more = ::write(file, text.data() + written, text.size() - written);
    if (more <= 0) return;
    written += static_cast<std::size_t>(more);
  }
}

std::string read_all(int file) {
  std::string text;
  char buffer[4096];
  for (ssize_t more = 0; (more = ::read(file, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(more));
  }
  return text;
}

Child begin(const SceneId& which, const std::function<Scene()>& scene_of, double max_seconds) {
  int ends[2] = {0, 0};
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(stdout);
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process == 0) {
    ::close(ends[0]);
    const Scene scene = scene_of();
    write_all(ends[1], to_csv(sum_up(which, scene, play(scene, max_seconds))));
    ::_exit(0);
  }
  ::close(ends[1]);
  return {which, process, ends[0], Clock::now()};
}

/// Reads the summary of an ended child. An empty pipe means that the child was killed or crashed.
Summary collect(const Child& child, bool was_ended) {
  const std::string line = read_all(child.pipe);
  ::close(child.pipe);
  Summary summary;
  if (!line.empty()) {
    summary = from_csv(line);
  } else {
    const Scene scene = generate(child.which);
    summary = sum_up(child.which, scene, {});
    summary.end = was_ended ? End::timed_out : End::crashed;
  }
  summary.which = child.which;
  return summary;
}

/// Returns whether the child has ended; kills it if its time is up. A summary fits into a pipe's buffer.
bool has_ended(const Child& child, double max_seconds, bool& was_ended) {
  int status = 0;
  if (::waitpid(child.process, &status, WNOHANG) == child.process) return true;
  if (std::chrono::duration<double>(Clock::now() - child.begun).count() < 1.5 * max_seconds + 1.0) return false;
  ::kill(child.process, SIGKILL);
  ::waitpid(child.process, &status, 0);
  was_ended = true;
  return true;
}

}  // namespace

void run_all(std::span<const SceneId> scenes, const RunOptions& options,
             const std::function<void(const Summary&)>& take) {
  std::vector<Child> children;
  std::size_t next = 0;
  while (next < scenes.size() || !children.empty()) {
    while (next < scenes.size() && static_cast<int>(children.size()) < options.jobs) {
      const SceneId which = scenes[next++];
      children.push_back(begin(
          which, [which] { return generate(which); }, options.max_seconds));
    }
    bool any = false;
    for (std::size_t k = 0; k < children.size();) {
      bool was_ended = false;
      if (!has_ended(children[k], options.max_seconds, was_ended)) {
        ++k;
        continue;
      }
      take(collect(children[k], was_ended));
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(k));
      any = true;
    }
    if (!any) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

Summary run_guarded(const SceneId& which, const Scene& scene, double max_seconds) {
  const Child child = begin(
      which, [&scene] { return scene; }, max_seconds);
  bool was_ended = false;
  while (!has_ended(child, max_seconds, was_ended)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return collect(child, was_ended);
}

}  // namespace any_scene
