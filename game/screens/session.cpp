#include "game/screens/session.h"

#include <utility>

#include "game/words/words.h"

namespace game {
namespace {

constexpr std::int64_t shown_for_ns = 6'000'000'000;

std::string below(const std::string& folder, const char* name) { return folder.empty() ? "" : folder + name; }

}  // namespace

void Notice::show(std::string sentence) {
  text_ = std::move(sentence);
  left_ns_ = shown_for_ns;
}

void Notice::advance(std::int64_t nanoseconds) {
  left_ns_ -= nanoseconds;
  if (left_ns_ <= 0) text_.clear();
}

Session::Session(const std::string& config_folder, const std::string& data_folder)
    : records(data_folder), runs(below(data_folder, "/runs")), settings_file_(below(config_folder, "/settings.json")) {
  std::string error;
  settings = settings_file_.load(error);
  records.load(error);
  if (!error.empty()) notice.show(error);
}

void Session::save_settings() {
  std::string error;
  settings_file_.save(settings, error);
  if (!error.empty()) notice.show(error);
}

void Session::report_no_recordings() {
  if (std::exchange(reported_, true)) return;
  notice.show(words::runs_not_recorded);
}

}  // namespace game
