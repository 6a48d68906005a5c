// SPDX-License-Identifier: Apache-2.0
// Pipelines made of what the JSON Schema of pipeline files allows.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "xgm/testing/random.hpp"

namespace xgm::testing {

/// Stereo pipelines: every stage and parameter of the schema is chosen sooner or later, with the
/// default, the ends of its range, or anything between.
class PipelineGenerator {
 public:
  PipelineGenerator(const std::string& schema, std::uint64_t seed);

  /// The text of a file; relations between parameters may be broken.
  std::string next();

 private:
  using Json = nlohmann::json;

  bool chance(int of) { return random_.integer(1, of) == 1; }
  Json fields_of(const Json& schema, int depth);
  Json value_of(const Json& field, int depth);
  Json stage_of(const std::string& kind, int depth);
  Json number_of(const Json& field);
  Json text();
  Json list_of(const Json& field, int depth);

  Json schema_, family_;
  Random random_;
};

}  // namespace xgm::testing
