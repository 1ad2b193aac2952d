#include "game/words/words.h"

#include <algorithm>

namespace game::words {

std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    result += text.substr(0, open);
    text.remove_prefix(open);
    const std::size_t close = text.find('}');
    if (close == std::string_view::npos) return result.append(text);
    const std::string_view name = text.substr(1, close - 1);
    const auto* const found =
        std::find_if(values.begin(), values.end(), [name](const auto& value) { return value.first == name; });
    if (found == values.end()) {
      result += text.front();
      text.remove_prefix(1);
    } else {
      result += found->second;
      text.remove_prefix(close + 1);
    }
  }
  return result;
}

}  // namespace game::words
