// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/result_cache.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "pipeline/result_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

/// The files of one result.
struct Entry {
  std::vector<fs::path> files{};  // that which says that they are complete is the first
  bool is_complete = false;
  std::uint64_t bytes = 0;
  fs::file_time_type used = fs::file_time_type::min();
};

/// "0123456789abcdef" of "0123456789abcdef_status.png"; empty if no result has such a file.
std::string id_of(const fs::path& file) {
  constexpr std::size_t kDigits = 16;
  const std::string name = file.filename().string();
  const bool is_id = name.find_first_not_of("0123456789abcdef") == kDigits;
  return is_id && (name[kDigits] == '.' || name[kDigits] == '_') ? name.substr(0, kDigits) : "";
}

/// Files may vanish while they are looked at: other runs remove some, too.
std::vector<Entry> entries_of(const std::string& folder) {
  std::map<std::string, Entry> entries;
  std::error_code unusable;
  for (const auto& file : fs::directory_iterator(folder, unusable)) {
    const std::string id = id_of(file.path());
    if (id.empty()) continue;
    std::error_code vanished;
    const std::uintmax_t bytes = file.file_size(vanished);
    const fs::file_time_type used = file.last_write_time(vanished);
    if (vanished) continue;
    Entry& entry = entries[id];
    const bool is_record = file.path().extension() == ".json";
    entry.is_complete = entry.is_complete || is_record;
    entry.files.insert(is_record ? entry.files.begin() : entry.files.end(), file.path());
    entry.bytes += bytes;
    entry.used = std::max(entry.used, used);
  }
  std::vector<Entry> all;
  for (auto& [id, entry] : entries) all.push_back(std::move(entry));
  return all;
}

/// Another run is at work on it, or was not long ago.
bool is_being_written(const Entry& entry) {
  constexpr std::chrono::hours kLongest(1);
  return !entry.is_complete && entry.used > fs::file_time_type::clock::now() - kLongest;
}

/// Names what is found and kept by the part of the scene.
class OfPart final : public KeptResults {
 public:
  OfPart(ResultCache& cache, std::string part) : cache_(cache), part_(std::move(part)) {}
  std::optional<MatchResult> find(const std::string& name) override {
    return cache_.find(part_ + ", " + name);
  }
  void keep(const std::string& name, const MatchResult& result) override {
    cache_.keep(part_ + ", " + name, result);
  }

 private:
  ResultCache& cache_;
  std::string part_;
};

}  // namespace

ResultCache::ResultCache(const std::string& folder, std::uint64_t bytes, const Json& question,
                         Tell tell)
    : limit_(bytes), tell_(std::move(tell)) {
  make_output_folder(folder, "--cache ");
  results_ = std::make_unique<ResultFolder>(folder, hash_text(question.dump()), tell_);
}

ResultCache::~ResultCache() = default;

std::optional<MatchResult> ResultCache::find(const std::string& name) {
  auto found = results_->find(name);
  if (!found) return std::nullopt;
  std::error_code vanished;  // a removed one is not missed before it is needed again
  fs::last_write_time(fs::path(results_->path()) / (results_->id(name) + ".json"),
                      fs::file_time_type::clock::now(), vanished);
  return found;
}

void ResultCache::keep(const std::string& name, const MatchResult& result) {
  if (!is_writable_) return;
  try {
    results_->write(name, result);
    trim();
  } catch (const Error& error) {
    is_writable_ = false;
    tell_("nothing more is kept in " + results_->path() + ": " + error.message());
  }
}

std::shared_ptr<KeptResults> ResultCache::of_part(const std::string& name) {
  return std::make_shared<OfPart>(*this, name);
}

const std::vector<std::string>& ResultCache::reused() const { return results_->found(); }

void ResultCache::trim() const {
  std::vector<Entry> entries = entries_of(results_->path());
  std::uint64_t bytes = 0;
  for (const Entry& entry : entries) bytes += entry.bytes;
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (bytes <= limit_) return;
    if (is_being_written(entry)) continue;
    for (const fs::path& file : entry.files) {
      std::error_code vanished;
      fs::remove(file, vanished);
    }
    bytes -= entry.bytes;
  }
}

}  // namespace xgm
