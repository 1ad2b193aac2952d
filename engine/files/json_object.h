#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "engine/files/ranges.h"

/// Reading JSON whose every fault is named. Included by sources only: no header of the engine brings in the library.
namespace engine {

/// What is wrong with a piece of JSON, in a sentence that begins with where it stands.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses a text nested at most `max_depth` deep. Throws a JsonError beginning with `where`, with line and column where
/// the parser knows them.
nlohmann::json parse_json(std::string_view text, const std::string& where, int max_depth);

/// The value as it stands in the file, shortened; `an object` or `an array` for those.
std::string json_in_words(const nlohmann::json& value);

/// An object of a JSON file with the words that say where in the file it is. All readers throw a JsonError if the field
/// is absent (those with `_or` return the fallback), has another type or is out of range. Refers to the JSON it was
/// given, which must outlive it.
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
  /// Says that the field is what it is, and what is accepted.
  [[noreturn]] void refuse(std::string_view key, const std::string& accepted) const;

 private:
  const nlohmann::json& require(std::string_view key, const std::string& accepted) const;

  const nlohmann::json* value_;
  std::string where_;
};

}  // namespace engine
