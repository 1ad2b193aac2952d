#include "engine/scene/tiled_properties.h"

#include <algorithm>

namespace engine {
namespace {

std::string in_words(bool value) { return value ? "true" : "false"; }
std::string in_words(std::int64_t value) { return std::to_string(value); }
std::string in_words(double value) { return number_in_words(value); }
std::string in_words(const std::string& value) { return in_quotes(value); }

std::string text_in_words(Choices choices) {
  return choices.size() == 0 ? "a text" : "one of " + list_in_words(choices);
}

}  // namespace

bool contains(Choices choices, std::string_view text) {
  return std::find(choices.begin(), choices.end(), text) != choices.end();
}

double Properties::number(std::string_view key, NumberRange accepted) const {
  const Value& value = require(key, range_in_words(accepted));
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  if (whole == nullptr && real == nullptr) refuse(key, value, range_in_words(accepted));
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  if (!accepted.contains(number)) refuse(key, value, range_in_words(accepted));
  return number;
}

double Properties::number_or(std::string_view key, double fallback, NumberRange accepted) const {
  return has(key) ? number(key, accepted) : fallback;
}

std::int64_t Properties::integer(std::string_view key, IntegerRange accepted) const {
  const Value& value = require(key, range_in_words(accepted));
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr || !accepted.contains(*number)) refuse(key, value, range_in_words(accepted));
  return *number;
}

std::int64_t Properties::integer_or(std::string_view key, std::int64_t fallback, IntegerRange accepted) const {
  return has(key) ? integer(key, accepted) : fallback;
}

bool Properties::boolean(std::string_view key) const {
  const Value& value = require(key, "true or false");
  const auto* truth = std::get_if<bool>(&value);
  if (truth == nullptr) refuse(key, value, "true or false");
  return *truth;
}

bool Properties::boolean_or(std::string_view key, bool fallback) const { return has(key) ? boolean(key) : fallback; }

std::string Properties::text(std::string_view key, Choices choices) const {
  const Value& value = require(key, text_in_words(choices));
  const auto* text = std::get_if<std::string>(&value);
  const bool accepted = text != nullptr && (choices.size() == 0 || contains(choices, *text));
  if (!accepted) refuse(key, value, text_in_words(choices));
  return *text;
}

std::string Properties::text_or(std::string_view key, std::string_view fallback, Choices choices) const {
  return has(key) ? text(key, choices) : std::string(fallback);
}

void Properties::check_known_properties(Choices known, std::span<const std::string> others) const {
  for (const auto& [key, value] : values_) {
    if (contains(known, key) || std::find(others.begin(), others.end(), key) != others.end()) continue;
    std::string accepted = list_in_words(known);
    for (const std::string& other : others) accepted += ", " + other;
    throw error("property " + in_quotes(key) + " is unknown, accepted are: " + accepted);
  }
}

MapError Properties::error(std::string_view sentence) const { return MapError(owner_ + ": " + std::string(sentence)); }

bool Properties::insert(const std::string& key, Value value) { return values_.emplace(key, std::move(value)).second; }

bool Properties::has(std::string_view key) const { return values_.find(key) != values_.end(); }

const Properties::Value& Properties::require(std::string_view key, const std::string& accepted) const {
  const auto found = values_.find(key);
  if (found != values_.end()) return found->second;
  throw error("property " + in_quotes(key) + " is missing, accepted is " + accepted);
}

void Properties::refuse(std::string_view key, const Value& found, const std::string& accepted) const {
  const std::string value = std::visit([](const auto& v) { return in_words(v); }, found);
  throw error("property " + in_quotes(key) + " is " + value + ", accepted is " + accepted);
}

}  // namespace engine
