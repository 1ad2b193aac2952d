#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>

#include "tests/game/program.h"

/// Programs that run during a test.
namespace test_support {

/// A child process that is killed in the destructor.
class Process {
 public:
  /// sh runs `command`; the last program in it should be exec'ed, so that signals reach it.
  explicit Process(const std::string& command) : id_(fork()) {
    if (id_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // if the test crashes, the child ends too
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (status_) return;
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }

  void send(int signal) const { kill(id_, signal); }
  /// Returns whether it still runs, after a wait of a millisecond.
  bool runs() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = status;
    usleep(1000);
    return !status_;
  }
  /// Waits for its end. Returns the exit status, or −1 if a signal ended it.
  int wait() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, 0) == id_) status_ = status;
    return status_ && WIFEXITED(*status_) ? WEXITSTATUS(*status_) : -1;
  }

 private:
  pid_t id_;
  std::optional<int> status_;
};

/// An X server with its own display. The display's number follows from this process's id. (A server that chooses a
/// number itself may take that of one that is just ending, which then removes the socket of both.)
class XServer {
 public:
  /// `screen`: 1280x720x24.
  explicit XServer(const std::string& screen) : screen_(screen) {}

  /// Waits until it accepts clients. Returns false if it ended instead, with every number tried.
  bool starts() {
    for (int attempt = 0; attempt < 3; ++attempt) {
      if (serves(first_number + (getpid() + attempt * attempts_apart) % number_count)) return true;
    }
    return false;
  }
  /// For example ":107"; empty before starts().
  const std::string& display() const { return display_; }
  void send(int signal) const { process_->send(signal); }

 private:
  static constexpr int first_number = 100;     // lower numbers are for desktops
  static constexpr int number_count = 50'000;  // a display's port, 6000 + number, is below 65536
  static constexpr int attempts_apart = 9973;

  bool serves(int number) {
    const std::string ready = scratch("display");
    fs::remove(ready);
    display_ = ":";
    display_ += std::to_string(number);
    // Without -noreset it restarts when its last client ends, and refuses clients meanwhile.
    process_.emplace("exec Xvfb " + display_ + " -noreset -displayfd 3 -screen 0 " + screen_ + " 3>" + ready +
                     " 2>/dev/null");
    while (bytes_of(ready).find('\n') == std::string::npos) {
      if (!process_->runs()) return false;
    }
    return true;
  }

  std::string screen_;
  std::string display_;
  std::optional<Process> process_;
};

}  // namespace test_support
