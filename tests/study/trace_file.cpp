#include "tests/study/trace_file.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

#include "ribbon/box2d/state_hash.h"
#include "tests/study/text.h"

namespace study {
namespace {

/// Writes values in their memory layout: only the program that wrote a file reads it.
class Writer {
 public:
  template <typename T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <typename T>
  void operator()(const std::vector<T>& values) {
    (*this)(values.size());
    for (const T& value : values) (*this)(value);
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads values that Writer has written; the caller has checked that they are complete.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(&bytes) {}
  template <typename T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, bytes_->data() + at_, sizeof value);
    at_ += sizeof value;
  }
  template <typename T>
  void operator()(std::vector<T>& values) {
    values.resize(size());
    for (T& value : values) (*this)(value);
  }
  void operator()(std::string& text) {
    const std::size_t length = size();
    text = bytes_->substr(at_, length);
    at_ += length;
  }

 private:
  std::size_t size() {
    std::size_t size = 0;
    (*this)(size);
    return size;
  }

  const std::string* bytes_;
  std::size_t at_ = 0;
};

/// Visits all members of a trace by name. A new member does not compile until it is saved too.
template <typename T, typename Visit>
void visit_all(T& trace, Visit& visit) {
  auto& [lengths, cords, places, player, bodies, stretch, figures, declared, crossings, mass, gravity, work, contacts,
         unconverged_ticks, tick_work, failure] = trace;
  visit(lengths);
  visit(cords);
  visit(places);
  visit(player);
  visit(bodies);
  visit(stretch);
  visit(figures);
  visit(declared);
  visit(crossings);
  visit(mass);
  visit(gravity);
  visit(work);
  visit(contacts);
  visit(unconverged_ticks);
  visit(tick_work);
  visit(failure);
}

/// The header of a file: the key, and the hash of the rest.
std::string head_of(const std::string& key, const std::string& content) {
  return key + ' ' + std::to_string(ribbon::box2d::hash_bytes(content)) + '\n';
}

}  // namespace

std::string bytes_of(const Trace& trace) {
  Writer writer;
  visit_all(trace, writer);
  return writer.bytes();
}

Trace trace_of(const std::string& bytes) {
  Trace trace;
  Reader reader(bytes);
  visit_all(trace, reader);
  return trace;
}

bool save_trace(const Trace& trace, const std::string& key, const std::string& path) {
  const std::string content = bytes_of(trace);
  const std::string beside = path + ".new";
  {
    std::ofstream out(beside, std::ios::binary);
    out << head_of(key, content) << content;
    out.flush();
    if (!out) return false;
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  return !error;
}

std::optional<Trace> load_trace(const std::string& key, const std::string& path) {
  const std::string all = read_file(path);
  const std::size_t end = all.find('\n');
  if (end == std::string::npos) return {};
  const std::string content = all.substr(end + 1);
  if (all.compare(0, end + 1, head_of(key, content)) != 0) return {};
  return trace_of(content);
}

}  // namespace study
