#include "tests/study/run_in_copy.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <stdexcept>
#include <string>

#include "tests/study/trace_file.h"

namespace study {
namespace {

constexpr char has_run = 'r';
constexpr char has_thrown = 't';

std::string result_of(const std::function<Trace()>& run) {
  try {
    return has_run + bytes_of(run());
  } catch (const std::exception& error) {
    return has_thrown + std::string(error.what());
  }
}

/// Returns false if not all could be written.
bool write_all(int file, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + done, bytes.size() - done);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 65536> part;
  for (ssize_t count = 0; (count = ::read(file, part.data(), part.size())) > 0;)
    bytes.append(part.data(), static_cast<std::size_t>(count));
  return bytes;
}

}  // namespace

Trace run_in_copy(const std::function<Trace()>& run) {
  std::array<int, 2> pipe{};  // its ends: to read from, to write to
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe to a copy of this process can be made");
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::close(pipe[0]);
    const bool written = write_all(pipe[1], result_of(run));
    ::_exit(written ? 0 : 1);  // what the parent has not printed yet is not printed twice
  }
  ::close(pipe[1]);
  const std::string result = copy < 0 ? std::string() : read_all(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  const bool ended = copy > 0 && ::waitpid(copy, &status, 0) == copy && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!ended || result.empty()) throw std::runtime_error("a run in a copy of this process ended early");
  if (result.front() == has_thrown) throw std::runtime_error(result.substr(1));
  return trace_of(result.substr(1));
}

}  // namespace study
