#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "engine/files/json_object.h"
#include "engine/files/regular_file.h"
#include "engine/replay/solver_step.h"
#include "engine/replay/solver_step_fields.h"

namespace engine {
namespace {

using nlohmann::json;
using step_fields::fields;

constexpr int max_depth = 8;
constexpr std::streamoff max_bytes = 256L << 20;

/// The location of a value, as a chain to the root. It is put into words only for an error.
struct Place {
  const Place* parent = nullptr;
  const char* name = "";
  std::size_t index = 0;

  std::string words() const {
    if (parent == nullptr) return name;
    const std::string before = parent->words();
    if (*name == '\0') return before + "[" + std::to_string(index) + "]";
    return parent->parent == nullptr ? name : before + "." + name;
  }
};

[[noreturn]] void refuse(const Place& place, const json& found, const std::string& accepted) {
  throw SolverStepError(place.words() + " is " + json_in_words(found) + "; accepted is " + accepted);
}

template <typename T>
void read(const Place& place, const json& from, T& to);

/// Reads the fields of one object. Missing and unknown fields are errors.
class FieldReader {
 public:
  FieldReader(const Place& place, const json& object) : place_(place), object_(object) {
    if (!object.is_object()) refuse(place, object, "an object");
  }

  template <typename T>
  void operator()(const char* name, T& value) {
    const Place place{&place_, name};
    const auto found = object_.find(name);
    if (found == object_.end())
      throw SolverStepError(place.words() + " is missing; accepted is a file with all fields");
    read(place, *found, value);
    names_.emplace_back(name);
  }

  void check_rest() const {
    if (names_.size() == object_.size()) return;
    for (const auto& [name, value] : object_.items()) {
      if (std::find(names_.begin(), names_.end(), name) != names_.end()) continue;
      throw SolverStepError((place_.parent == nullptr ? "" : place_.words() + ": ") + "there is no field " +
                            in_quotes(name) + "; accepted are " + accepted());
    }
  }

 private:
  std::string accepted() const {
    std::string words;
    for (const std::string_view name : names_) words += (words.empty() ? "" : ", ") + std::string(name);
    return words;
  }

  const Place& place_;
  const json& object_;
  std::vector<std::string_view> names_;
};

void read(const Place& place, const json& from, double& to) {
  if (from.is_string()) {
    const auto& text = from.get_ref<const std::string&>();
    if (text != "infinity" && text != "-infinity") refuse(place, from, "a number, or \"infinity\" or \"-infinity\"");
    to = text == "infinity" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    return;
  }
  if (!from.is_number()) refuse(place, from, "a number");
  to = from.get<double>();
}

void read(const Place& place, const json& from, ribbon::Vec2& to) {
  if (!from.is_array() || from.size() != 2) refuse(place, from, "an array of two numbers");
  read({&place, "x"}, from[0], to.x);
  read({&place, "y"}, from[1], to.y);
}

void read(const Place& place, const json& from, bool& to) {
  if (!from.is_boolean()) refuse(place, from, "true or false");
  to = from.get<bool>();
}

void read(const Place& place, const json& from, std::string& to) {
  if (!from.is_string()) refuse(place, from, "a text");
  to = from.get<std::string>();
}

template <std::integral T>
void read_whole(const Place& place, const json& from, T& to, T low, T high) {
  const bool fits = from.is_number_unsigned()  ? std::cmp_less_equal(from.get<std::uint64_t>(), high)
                    : from.is_number_integer() ? std::cmp_greater_equal(from.get<std::int64_t>(), low)
                                               : false;
  if (!fits) refuse(place, from, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  to = from.get<T>();
}

template <typename T>
void read_name(const Place& place, const json& from, T& to) {
  constexpr auto& names = step_fields::names_of<T>;
  const auto found =
      from.is_string() ? std::find(names.begin(), names.end(), from.get_ref<const std::string&>()) : names.end();
  if (found == names.end()) {
    std::string words;
    for (const std::string_view name : names) words += (words.empty() ? "" : ", ") + std::string(name);
    refuse(place, from, words);
  }
  to = static_cast<T>(found - names.begin());
}

template <typename T>
void read(const Place& place, const json& from, std::vector<T>& to) {
  if (!from.is_array()) refuse(place, from, "an array");
  to.resize(from.size());
  for (std::size_t k = 0; k < to.size(); ++k) read({&place, "", k}, from[k], to[k]);
}

template <typename T>
void read(const Place& place, const json& from, T& to) {
  if constexpr (std::is_enum_v<T>) {
    read_name(place, from, to);
  } else if constexpr (std::same_as<T, char>) {
    int flag = 0;
    read_whole(place, from, flag, 0, 1);
    to = static_cast<char>(flag);
  } else if constexpr (std::integral<T>) {
    read_whole<T>(place, from, to, std::numeric_limits<T>::min(), std::numeric_limits<T>::max());
  } else {
    FieldReader reader(place, from);
    fields(reader, to);
    reader.check_rest();
  }
}

SolverStep read_file(const json& file) {
  const Place root{nullptr, "the file"};
  FieldReader reader(root, file);
  int version = 0;
  reader("solver_step", version);
  if (version != step_fields::solver_step_version) {
    throw SolverStepError("solver_step is version " + std::to_string(version) + "; accepted is " +
                          std::to_string(step_fields::solver_step_version));
  }
  SolverStep step;
  fields(reader, step);
  reader.check_rest();
  check(step);
  return step;
}

}  // namespace

SolverStep read_solver_step(std::string_view text, const std::string& where) {
  try {
    return read_file(parse_json(text, where, max_depth));
  } catch (const JsonError& error) {
    throw SolverStepError(error.what());
  } catch (const SolverStepError& error) {
    throw SolverStepError(where + ": " + error.what());
  }
}

SolverStep load_solver_step(const std::string& path) {
  std::string text;
  try {
    std::ifstream in = open_regular_file(path);
    in.seekg(0, std::ios::end);
    const std::streamoff bytes = in.tellg();
    if (bytes > max_bytes) throw SolverStepError(path + ": has more than the 256 MiB accepted");
    in.seekg(0);
    text.resize(static_cast<std::size_t>(std::max(bytes, std::streamoff{0})));
    if (!in.read(text.data(), static_cast<std::streamsize>(text.size())))
      throw SolverStepError(path + ": cannot be read to its end");
  } catch (const SolverStepError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw SolverStepError(error.what());
  }
  return read_solver_step(text, path);
}

}  // namespace engine
