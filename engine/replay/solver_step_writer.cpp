#include <cerrno>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/files/number_text.h"
#include "engine/replay/solver_step.h"
#include "engine/replay/solver_step_fields.h"

namespace engine {
namespace {

using step_fields::fields;

/// True for types whose fields get a line each; all others are written in the line of their parent.
template <typename T>
constexpr bool has_lines = std::same_as<T, SolverStep> || std::same_as<T, SolverStep::Cord> ||
                           std::same_as<T, ribbon::CordDef> || std::same_as<T, ribbon::Cord::State>;

class Writer {
 public:
  template <typename T>
  void operator()(const char* name, const T& value) {
    separate();
    append_text(name);
    text_ += ": ";
    put(value);
  }

  template <typename T>
  void put(const T& value) {
    if constexpr (requires { fields(*this, value); }) {
      put_object(value);
    } else if constexpr (std::is_enum_v<T>) {
      append_text(std::string(step_fields::names_of<T>[static_cast<std::size_t>(value)]));
    } else {
      text_ += std::to_string(value);
    }
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    constexpr bool in_lines = requires(Writer & writer, const T& value) { fields(writer, value); };
    open('[', in_lines && !values.empty());
    for (const T& value : values) {
      separate();
      put(value);
    }
    close(']');
  }
  void put(double value) {
    if (!std::isfinite(value)) {
      append_text(std::isnan(value) ? "nan" : value > 0.0 ? "infinity" : "-infinity");
      return;
    }
    const std::string written = shortest_text(value);
    text_ += written;
    // Without ".0" the reader would take a whole number for an integer, which has no −0 and a limited range.
    if (written.find_first_not_of("-0123456789") == std::string::npos) text_ += ".0";
  }
  void put(ribbon::Vec2 v) {
    text_ += '[';
    put(v.x);
    text_ += ", ";
    put(v.y);
    text_ += ']';
  }
  void put(bool value) { text_ += value ? "true" : "false"; }
  void put(char value) { text_ += value != 0 ? '1' : '0'; }
  void put(const std::string& value) { append_text(value); }

  std::string take() { return std::move(text_) + "\n"; }

  void begin_file() {
    open('{', true);
    (*this)("solver_step", step_fields::solver_step_version);
  }
  void end_file() { close('}'); }

 private:
  struct Level {
    bool in_lines;
    bool is_empty = true;
  };

  template <typename T>
  void put_object(const T& value) {
    open('{', has_lines<T>);
    fields(*this, value);
    close('}');
  }
  void open(char bracket, bool in_lines) {
    text_ += bracket;
    levels_.push_back({in_lines});
  }
  void close(char bracket) {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.in_lines && !level.is_empty) begin_line();
    text_ += bracket;
  }
  void separate() {
    Level& level = levels_.back();
    if (!level.is_empty) text_ += level.in_lines ? "," : ", ";
    level.is_empty = false;
    if (level.in_lines) begin_line();
  }
  void begin_line() {
    text_ += '\n';
    text_.append(levels_.size(), ' ');
  }
  void append_text(const std::string& text) {
    text_ += nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  }

  std::string text_;
  std::vector<Level> levels_;
};

[[noreturn]] void fail(const std::string& path) {
  const std::string reason = errno == 0 ? "reason unknown" : std::generic_category().message(errno);
  throw SolverStepError(path + ": cannot be written: " + reason);
}

}  // namespace

std::string to_text(const SolverStep& step) {
  Writer writer;
  writer.begin_file();
  fields(writer, step);
  writer.end_file();
  return writer.take();
}

bool save_solver_step(const SolverStep& step, const std::string& path, bool is_new) {
  const std::string text = to_text(step);
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), is_new ? "wbx" : "wb");
  if (file == nullptr && is_new && errno == EEXIST) return false;
  if (file == nullptr) fail(path);
  bool is_whole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  is_whole = std::fflush(file) == 0 && is_whole;
  const int reason = errno;
  if (std::fclose(file) == 0 && is_whole) return true;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);  // not a device
  errno = reason;
  fail(path);
}

}  // namespace engine
