#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "engine/files/ranges.h"

namespace engine {

/// A map cannot be loaded or used. The message has the file, the object (id and name) and property if there is one, the
/// value found and what is accepted.
class MapError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns whether the text is one of the choices.
bool contains(Choices choices, std::string_view text);

/// The custom properties of a map or of one object, read by name and type. The readers throw a MapError if the property
/// has another type, is out of range, or is missing; those with `_or` return the fallback, unchecked, if it is missing.
class Properties {
 public:
  using Value = std::variant<bool, std::int64_t, double, std::string>;

  Properties() = default;
  /// `owner`: file and object, the start of all messages.
  explicit Properties(std::string owner) : owner_(std::move(owner)) {}

  bool has(std::string_view key) const;

  /// A `float` or `int` property.
  double number(std::string_view key, NumberRange accepted = {}) const;
  double number_or(std::string_view key, double fallback, NumberRange accepted = {}) const;
  /// An `int` property, or an `object` property (the id that it refers to, 0 for none).
  std::int64_t integer(std::string_view key, IntegerRange accepted = {}) const;
  std::int64_t integer_or(std::string_view key, std::int64_t fallback, IntegerRange accepted = {}) const;
  /// A `bool` property.
  bool boolean(std::string_view key) const;
  bool boolean_or(std::string_view key, bool fallback) const;
  /// A `string`, `color` or `file` property; one of `choices` unless `choices` is empty.
  std::string text(std::string_view key, Choices choices = {}) const;
  std::string text_or(std::string_view key, std::string_view fallback, Choices choices = {}) const;

  /// Throws a MapError for the first property, in alphabetical order, that is neither in `known` nor in `others`.
  void check_known_properties(Choices known, std::span<const std::string> others = {}) const;

  /// Returns an error to throw about this owner: `levels/a.tmj: object 12 "rope": ` and the sentence.
  MapError error(std::string_view sentence) const;

  /// Adds a property. Returns false, without a change, if there already is one with that name.
  bool insert(const std::string& key, Value value);

 private:
  const Value& require(std::string_view key, const std::string& accepted) const;
  [[noreturn]] void refuse(std::string_view key, const Value& found, const std::string& accepted) const;

  std::string owner_;
  std::map<std::string, Value, std::less<>> values_;
};

}  // namespace engine
