#include "game/settings/records.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>

#include "engine/files/json_object.h"
#include "game/settings/user_files.h"
#include "game/words/words.h"
#include "ribbon/box2d/state_hash.h"

namespace game {
namespace {

using engine::JsonObject;

constexpr int records_depth = 5;
constexpr int version = 2;
constexpr std::size_t hash_digits = 16;

std::uint64_t read_hash(const JsonObject& object) {
  const std::string digits = object.text("hash");
  const bool valid = digits.size() == hash_digits && digits.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!valid) object.refuse("hash", "16 hexadecimal digits");
  return std::stoull(digits, nullptr, 16);
}

/// Reads the ticks at the checkpoints, null for one that was not entered.
std::vector<std::optional<int>> read_splits(const JsonObject& object, std::int64_t ticks) {
  std::vector<std::optional<int>> splits;
  if (!object.has("splits")) return splits;
  for (const auto& value : object.array("splits")) {
    const bool valid = value.is_null() || (value.is_number_integer() && value >= 0 && value <= ticks);
    if (!valid) object.refuse("splits", "a list of null and whole numbers from 0 to the ticks of the run");
    splits.push_back(value.is_null() ? std::nullopt : std::optional(value.get<int>()));
  }
  return splits;
}

nlohmann::ordered_json splits_json(const std::vector<std::optional<int>>& splits) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::optional<int>& split : splits) {
    list.push_back(split ? nlohmann::ordered_json(*split) : nlohmann::ordered_json(nullptr));
  }
  return list;
}

}  // namespace

std::vector<Records::Entry> Records::parse(const std::string& text, const std::string& where) {
  const nlohmann::json json = engine::parse_json(text, where, records_depth);
  std::vector<Entry> entries;
  const JsonObject whole(json, where);
  if (whole.has("version")) static_cast<void>(whole.integer("version", {1, version}));
  for (const auto& value : whole.array("best")) {
    const JsonObject object(value, where + ": record " + std::to_string(entries.size() + 1));
    const auto ticks = object.integer("ticks", {1, std::numeric_limits<int>::max()});
    const Best best{static_cast<int>(ticks), object.boolean_or("assisted", false), read_splits(object, ticks)};
    entries.push_back({{object.text("level"), read_hash(object)}, best});
  }
  return entries;
}

std::string Records::text() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& entry : entries_) {
    list.push_back({{"level", entry.level.name},
                    {"hash", ribbon::box2d::to_hex(entry.level.hash)},
                    {"ticks", entry.best.ticks},
                    {"assisted", entry.best.assisted}});
    if (!entry.best.splits.empty()) list.back()["splits"] = splits_json(entry.best.splits);
  }
  return nlohmann::ordered_json{{"version", version}, {"best", list}}.dump(2) + "\n";
}

void Records::load(std::string& notice) {
  entries_.clear();
  if (folder_.empty()) return;
  try {
    if (const auto text = read_user_file(file())) entries_ = parse(*text, file());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    rename_broken(file());
    notice = words::times_unreadable;
  }
}

std::optional<Best> Records::best(const LevelKey& level) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.level == level; });
  return found == entries_.end() ? std::nullopt : std::optional(found->best);
}

bool Records::offer(const LevelKey& level, const Best& run, const std::string& recording, std::string& notice) {
  const auto before = best(level);
  if (before && !run.is_better_than(*before)) return false;
  std::erase_if(entries_, [&](const Entry& entry) { return entry.level == level; });
  entries_.push_back({level, run});
  write(level, recording, notice);
  return true;
}

void Records::add_splits(const LevelKey& level, int ticks, std::vector<std::optional<int>> splits,
                         std::string& notice) {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.level == level; });
  if (found == entries_.end() || found->best.ticks != ticks || !found->best.splits.empty()) return;
  found->best.splits = std::move(splits);
  try_to_write([this] { write_user_file(file(), text()); }, notice);
}

void Records::write(const LevelKey& level, const std::string& recording, std::string& notice) {
  const auto write_all = [&] {
    // Removed first: if writing fails, the recording of an earlier run must not stay with the new record.
    std::error_code ignored;
    std::filesystem::remove(replay_path(level), ignored);
    write_user_file(file(), text());
    if (!recording.empty()) copy_user_file(recording, replay_path(level));
  };
  try_to_write(write_all, notice);
}

template <typename Write>
void Records::try_to_write(Write write, std::string& notice) {
  if (folder_.empty()) return;
  try {
    write();
  } catch (const std::exception& error) {
    if (failed_) return;
    failed_ = true;
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    notice = words::times_not_written;
  }
}

std::string Records::replay_path(const LevelKey& level) const {
  if (folder_.empty()) return "";
  return folder_ + "/best/" + level.name + "-" + ribbon::box2d::to_hex(level.hash) + ".replay";
}

}  // namespace game
