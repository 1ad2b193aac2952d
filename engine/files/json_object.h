#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "engine/files/ranges.h"

/// Reads JSON with an error message for each kind of fault. Include it in sources only, so that no header of the engine
/// includes the JSON library.
namespace engine {

/// An error in a piece of JSON. The message begins with its location.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses a text that nests at most `max_depth` deep. Throws a JsonError whose message begins with `where` and includes
/// line and column if the parser knows them.
nlohmann::json parse_json(std::string_view text, const std::string& where, int max_depth);

/// Returns the value as JSON, shortened, for messages; `an object` or `an array` for those.
std::string json_in_words(const nlohmann::json& value);

/// An object of a JSON file and its location in words. The readers throw a JsonError if the field is missing (those
/// with `_or` return the fallback), has another type or is out of range. Refers to the JSON value, which must outlive
/// it.
class JsonObject {
 public:
  JsonObject(const nlohmann::json& value, std::string where);

  const std::string& where() const { return where_; }
  void rename(std::string where) { where_ = std::move(where); }
  const nlohmann::json& value() const { return *value_; }

  bool has(std::string_view key) const { return value_->contains(key); }
  double number(std::string_view key, NumberRange accepted = {}) const;
  double number_or(std::string_view key, double fallback, NumberRange accepted = {}) const;
  std::int64_t integer(std::string_view key, IntegerRange accepted = {}) const;
  bool boolean_or(std::string_view key, bool fallback) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string_view fallback) const;
  const nlohmann::json& array(std::string_view key) const;
  JsonObject object(std::string_view key) const;

  [[noreturn]] void fail(const std::string& sentence) const { throw JsonError(where_ + ": " + sentence); }
  /// Throws a JsonError with the value of the field and what is accepted. The field must exist.
  [[noreturn]] void refuse(std::string_view key, const std::string& accepted) const;

 private:
  const nlohmann::json& require(std::string_view key, const std::string& accepted) const;

  const nlohmann::json* value_;
  std::string where_;
};

}  // namespace engine
