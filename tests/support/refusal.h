#pragma once

#include <gtest/gtest.h>

#include <string>

namespace test_support {

/// Returns the message of the `Error` that the call throws, or "no error".
template <typename Error, typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Fails, with the whole message, unless it contains `part`.
inline testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the message is: " << message << "\nand should contain: " << part;
}

/// Fails, with the whole message, unless it starts with `start`.
inline testing::AssertionResult starts_with(const std::string& message, const std::string& start) {
  if (message.rfind(start, 0) == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the message is: " << message << "\nand should start with: " << start;
}

}  // namespace test_support
