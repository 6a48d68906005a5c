// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/run_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/write_maps.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kUnfinishedFile = "unfinished.json";
constexpr const char* kOption = "--output";

/// The folder that may be made.
const std::string& checked(const std::string& folder, const std::vector<NamedFile>& inputs,
                           const std::vector<NamedFile>& planned) {
  require_apart(inputs, planned);
  return folder;
}

/// Its name within the folder; empty if it lies elsewhere.
std::string name_within(const std::string& folder, const std::string& file) {
  const fs::path path = fs::absolute(file);  // its last part may be a link, which is replaced
  const fs::path place = fs::weakly_canonical(path.parent_path()) / path.filename();
  const fs::path name = place.lexically_relative(fs::canonical(folder));
  return name.empty() || *name.begin() == ".." ? "" : name.string();
}

std::vector<OutputFile> listed_in(const std::string& file) {
  std::error_code unusable;
  if (!fs::is_regular_file(file, unusable)) return {};
  try {
    return recorded_outputs(read_file(file));
  } catch (const Error&) {
    return {};  // it is empty, or cannot be read: it lists nothing
  }
}

/// What is there under names that results have which not every run writes.
std::vector<std::string> optional_results(const fs::path& folder, std::vector<std::string> names) {
  std::error_code unusable;
  names.insert(names.end(), {kConfidenceFile, kReportFile, kExplanationsFile});
  std::erase_if(names, [&](const auto& name) { return !fs::exists(folder / name, unusable); });
  const fs::path dumps = folder / kDumpFolder;
  if (!fs::is_directory(dumps, unusable)) {
    if (fs::exists(dumps, unusable)) names.push_back(kDumpFolder);
    return names;
  }
  for (const auto& entry : fs::directory_iterator(dumps, unusable)) {
    names.push_back((kDumpFolder / entry.path().filename()).string());
  }
  return names;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

RunFolder::RunFolder(const std::string& folder, const std::vector<NamedFile>& planned,
                     const std::vector<NamedFile>& inputs, const std::vector<std::string>& optional)
    : folder_(folder), place_(checked(folder, inputs, planned), std::string(kOption) + " ") {
  for (const char* list : {kRecordFile, kUnfinishedFile}) {
    for (OutputFile& output : listed_in(file(list))) earlier_.push_back(std::move(output));
  }
  for (const NamedFile& output : planned) {
    if (output.file.empty()) continue;
    const std::string name = name_within(folder, output.file);
    if (!name.empty() && name != kRecordFile) planned_.push_back(name);
  }
  require_apart(inputs, {{kOption, file(kUnfinishedFile)}});
  for (const OutputFile& output : earlier_) {
    if (!holds(planned_, output.file)) require_apart(inputs, {{kOption, file(output.file)}});
  }
  refuse_lookalikes(optional);
}

std::string RunFolder::file(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

void RunFolder::refuse_lookalikes(const std::vector<std::string>& optional) const {
  const auto refuse = [&](const std::string& name, const std::string& reason) {
    throw UsageError(std::string(kOption) + " " + folder_ + ": " + file(name) + " " + reason +
                     ", and would be taken for a result of this run; move it away, or give "
                     "another " +
                     kOption);
  };
  for (const std::string& name : optional_results(folder_, optional)) {
    const bool known = std::any_of(earlier_.begin(), earlier_.end(),
                                   [&](const OutputFile& output) { return output.file == name; });
    if (!known && !holds(planned_, name)) refuse(name, "is no file that run.json lists");
  }
  std::error_code unusable;
  for (const OutputFile& output : earlier_) {
    const std::uintmax_t bytes = fs::file_size(file(output.file), unusable);
    if (unusable || holds(planned_, output.file) || bytes == output.bytes.value_or(bytes)) continue;
    refuse(output.file, "has been changed after the run that wrote it");
  }
}

void RunFolder::begin() {
  if (begun_) return;
  begun_ = true;
  write_list();
  remove_file(file(kRecordFile));
  for (const OutputFile& output : earlier_) remove_file(file(output.file));
  ::rmdir(file(kDumpFolder).c_str());  // if nothing is left in it
}

void RunFolder::announce(const std::string& file) {
  announced_.push_back(fs::path(file).lexically_relative(folder_).string());
  if (begun_) write_list();
  begin();
}

void RunFolder::write_list() const {
  std::vector<OutputFile> files = earlier_;
  for (const auto* names : {&planned_, &announced_}) {
    for (const std::string& name : *names) files.push_back({name, {}});
  }
  write_file(file(kUnfinishedFile), Json{{"outputs", to_json(files)}}.dump(2) + "\n");
}

std::vector<OutputFile> RunFolder::outputs() const {
  std::vector<OutputFile> files;
  for (const auto* names : {&planned_, &announced_}) {
    for (const std::string& name : *names) {
      std::error_code missing;
      const std::uintmax_t bytes = fs::file_size(file(name), missing);
      if (!missing) files.push_back({name, bytes});
    }
  }
  return files;
}

void RunFolder::end() { remove_file(file(kUnfinishedFile)); }

void RunFolder::discard() {
  if (!begun_) return;
  for (const std::string& name : announced_) remove_file(file(name));
  ::rmdir(file(kDumpFolder).c_str());
  end();
}

}  // namespace xgm
