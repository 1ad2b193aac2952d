#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>

#include "tests/game/program.h"

/// Programs that run beside a test.
namespace test_support {

/// A process of this test's own, ended with it.
class Process {
 public:
  /// `command` is run by sh; the last program in it should be exec'ed, so that signals reach it.
  explicit Process(const std::string& command) : id_(fork()) {
    if (id_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // with a test that crashes it ends, too
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
  /// Whether it runs on; looked at again and again, a millisecond apart.
  bool runs() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = status;
    usleep(1000);
    return !status_;
  }
  /// What it ended with: the exit status, or −1 if a signal ended it.
  int wait() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, 0) == id_) status_ = status;
    return status_ && WIFEXITED(*status_) ? WEXITSTATUS(*status_) : -1;
  }

 private:
  pid_t id_;
  std::optional<int> status_;
};

/// An X server on a display of its own.
class XServer {
 public:
  /// `screen`: 1280x720x24.
  explicit XServer(const std::string& screen)
      : process_("exec Xvfb -displayfd 3 -screen 0 " + screen + " 3>" + fresh() + " 2>/dev/null") {}

  /// Waits until it is there; false if it has ended instead.
  bool starts() {
    while (bytes_of(number()).find('\n') == std::string::npos) {
      if (!process_.runs()) return false;
    }
    return true;
  }
  /// ":7", once it is there.
  std::string display() const {
    std::string name = ":";
    name += bytes_of(number());
    name.pop_back();  // the line's end
    return name;
  }
  void send(int signal) const { process_.send(signal); }

 private:
  static std::string number() { return scratch("display"); }
  static std::string fresh() {
    fs::remove(number());
    return number();
  }

  Process process_;
};

}  // namespace test_support
