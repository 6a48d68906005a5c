// SPDX-License-Identifier: Apache-2.0
#include "pipeline/named_parts.hpp"

#include <array>
#include <filesystem>
#include <fstream>

#include "config/fields.hpp"
#include "pipeline/family_meant.hpp"
#include "xgm/base/error.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm {
namespace {

constexpr std::string_view kPipeline = PipelineFamily::kKind;

/// The file that a name stands for; empty, with a diagnostic, if there is none.
std::string find_part(const Node& name, Diagnostics& diagnostics) {
  const std::filesystem::path beside =
      std::filesystem::path(name.where.file).parent_path() / name.scalar;
  std::error_code failed;
  if (std::filesystem::is_regular_file(beside, failed)) return beside.string();
  try {
    return find_pipeline(name.scalar);
  } catch (const UsageError& error) {
    add_diagnostic(diagnostics, name.where, error.what(), "");
    return {};
  }
}

/// What the file holds, as a stage of kind "pipeline".
std::optional<Node> read_part(const std::string& file, Diagnostics& diagnostics) {
  const auto text = read_pipeline_text(file, diagnostics);
  std::optional<Node> part = text ? read_yaml(*text, file, diagnostics) : std::nullopt;
  if (!part || !part->is_map()) return part;
  std::erase_if(part->entries, [](const Entry& entry) { return entry.key == "xgm"; });
  if (part->find("type") == nullptr) put_type(*part, PipelineFamily::kDefault);
  return part;
}

}  // namespace

void read_named_parts(Node& root, const Registry& registry, Diagnostics& diagnostics) {
  const Entry* const type = root.find("type");
  const std::string_view family =
      type != nullptr ? std::string_view(type->value.scalar) : PipelineFamily::kDefault;
  const PluginInfo* const plugin = registry.find(kPipeline, family);
  if (plugin == nullptr) return;  // the binder says what is wrong
  const std::unique_ptr<Prototype> prototype = plugin->prototype();
  for (const Field& field : prototype->parameters().fields()) {
    Entry* const entry = root.find(field.name);
    const bool is_name = std::holds_alternative<SlotBase*>(field.target) && entry != nullptr &&
                         entry->value.is_scalar() && stage_kind(field) == kPipeline &&
                         registry.find(kPipeline, entry->value.scalar) == nullptr;
    if (!is_name) continue;
    const std::string file = find_part(entry->value, diagnostics);
    if (file.empty()) continue;
    if (auto part = read_part(file, diagnostics)) entry->value = std::move(*part);
  }
}

std::optional<std::string> read_pipeline_text(const std::string& file, Diagnostics& diagnostics) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 16> piece;
  while (stream && text.size() <= kMaxYamlBytes) {  // what is named by mistake may have no end
    stream.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.is_open() && !stream.bad()) return text;
  add_diagnostic(diagnostics, {file}, "cannot be read", "check the path and the permissions");
  return std::nullopt;
}

}  // namespace xgm
