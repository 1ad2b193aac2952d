#include "tests/flight/code.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/files/ranges.h"
#include "engine/replay/solver_step_fields.h"

namespace flight {
namespace {

using engine::SolverStep;
using engine::step_fields::fields;

constexpr std::size_t line_width = 110;

std::string expression(double value) {
  if (std::isnan(value)) return "std::numeric_limits<double>::quiet_NaN()";
  if (std::isinf(value))
    return value > 0.0 ? "std::numeric_limits<double>::infinity()" : "-std::numeric_limits<double>::infinity()";
  std::string digits = engine::number_in_words(value);
  return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0" : digits;
}
std::string expression(ribbon::Vec2 v) {
  std::string text = "{";
  text += expression(v.x);
  text += ", ";
  text += expression(v.y);
  text += '}';
  return text;
}
std::string expression(bool value) { return value ? "true" : "false"; }
std::string expression(char value) { return value != 0 ? "1" : "0"; }
std::string expression(int value) { return std::to_string(value); }
std::string expression(std::uint64_t value) { return std::to_string(value) + "U"; }

template <typename Enum>
constexpr const char* type_name = "";
template <>
constexpr const char* type_name<ribbon::PointKind> = "ribbon::PointKind::";
template <>
constexpr const char* type_name<ribbon::Integrator> = "ribbon::Integrator::";
template <>
constexpr const char* type_name<ribbon::Elements> = "ribbon::Elements::";

template <typename Enum>
requires std::is_enum_v<Enum> std::string expression(Enum value) {
  return type_name<Enum> + std::string(engine::step_fields::names_of<Enum>[static_cast<std::size_t>(value)]);
}

/// Formats a list in braces, wrapped into lines.
template <typename T>
std::string list_expression(const std::vector<T>& values) {
  std::string text = "{";
  std::size_t line = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string next = expression(static_cast<T>(values[k])) + (k + 1 < values.size() ? "," : "");
    const bool breaks = text.size() - line + next.size() > line_width;
    if (breaks) line = text.size();
    if (k > 0) text += breaks ? "\n      " : " ";
    text += next;
  }
  return text + "}";
}

/// Writes assignments to the fields of the object named `path`.
class Statements {
 public:
  explicit Statements(std::string path) : path_(std::move(path)) {}

  template <typename T>
  void operator()(const char* name, const T& value) {
    const std::string path = path_ + "." + name;
    if constexpr (requires { fields(*this, value); }) {
      Statements inner(path);
      fields(inner, value);
      list_.insert(list_.end(), inner.list_.begin(), inner.list_.end());
    } else {
      list_.push_back(path + " = " + expression(value) + ";");
    }
  }
  void operator()(const char* /*name*/, const SolverStep::Outcome& /*outcome*/) {}

  template <typename T>
  void operator()(const char* name, const std::vector<T>& values) {
    if (values.empty()) return;
    const std::string path = path_ + "." + name;
    const std::string count = std::to_string(values.size());
    if constexpr (requires(const T& value) { fields(*this, value); }) {
      list_.push_back(path + ".resize(" + count + ");");
      for (std::size_t k = 0; k < values.size(); ++k)
        add_all_but_defaults(path + "[" + std::to_string(k) + "]", values[k]);
    } else if (values.size() > 2 && std::all_of(values.begin(), values.end(), [&](const T& v) {
                 return expression(v) == expression(values.front());
               })) {
      list_.push_back(path + ".assign(" + count + ", " + expression(values.front()) + ");");
    } else {
      list_.push_back(path + " = " + list_expression(values) + ";");
    }
  }

  template <typename T>
  void add_all_but_defaults(const std::string& path, const T& value) {
    Statements found(path);
    fields(found, value);
    Statements defaults(path);
    const T plain{};
    fields(defaults, plain);
    for (std::string& statement : found.list_) {
      const bool is_default =
          std::find(defaults.list_.begin(), defaults.list_.end(), statement) != defaults.list_.end();
      if (!is_default) list_.push_back(std::move(statement));
    }
  }

  const std::vector<std::string>& list() const { return list_; }

 private:
  std::string path_;
  std::vector<std::string> list_;
};

constexpr const char* head = R"(#include <gtest/gtest.h>

#include <limits>

#include "tests/flight/replay.h"

namespace {

)";

}  // namespace

std::string code_of(const SolverStep& step, std::int64_t max_work) {
  Statements statements("");
  statements.add_all_but_defaults("step", step);
  std::string text = head;
  if (!step.outcome.why.empty()) text += "/// " + engine::in_quotes(step.outcome.why) + "\n";
  text += "engine::SolverStep recorded_step() {\n  engine::SolverStep step;\n";
  for (const std::string& statement : statements.list()) text += "  " + statement + "\n";
  text += "  return step;\n}\n\nTEST(RecordedStep, Converges) {\n";
  text += "  const engine::SolverStep step = recorded_step();\n  flight::Replay replay(step);\n  replay.run();\n";
  text += "  EXPECT_EQ(replay.total().unconverged, 0);\n";
  text += "  EXPECT_LE(replay.total().work, " + std::to_string(max_work) + ");\n}\n\n}  // namespace\n";
  return text;
}

}  // namespace flight
