// SPDX-License-Identifier: Apache-2.0
// A question to a program of somebody else's, and its answers, as files (docs/external.md).
#pragma once

#include <memory>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/data/volume.hpp"
#include "xgm/exchange/costs.hpp"
#include "xgm/exchange/program.hpp"

namespace xgm::exchange {

enum class ImageFiles {
  png,  ///< 8 bit
  npy,  ///< the grey levels as they are
};

/// The parameter that says in which files a stage hands images over.
XGM_API void declare(ImageFiles& files, ParameterSet& set);

/// What is asked about the right view is handed over mirrored, and its answer mirrored back: a
/// program always sees a pair whose near objects have the larger disparities. The folder of the
/// files, which nobody else can read, is gone with the request.
class XGM_API Request {
 public:
  /// `kind`: of the stage. Throws Error if no folder can be made.
  Request(std::string kind, const ImagePair& pair, ImageFiles files, const Context& context);
  ~Request();
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  /// What is searched.
  void add(const DisparityRange& range);
  void add(const DisparityMap& map);

  /// Throws what run_program() throws.
  void run(const Program& program);

  /// The disparities (px, NaN = none) of disparity.npy or disparity.pfm, in the pixels and with the
  /// sign of the pair that was given. Throws Error unless it is there, of the images' size and
  /// holds a number that is finite.
  cv::Mat1f disparities() const;
  /// confidence.npy or confidence.pfm; empty if there is none.
  cv::Mat1f confidence() const;
  /// cost.npy: read_costs() of it.
  CostVolume costs(const ImagePair& pair, const VolumeShapePtr& shape,
                   const CostScale& scale) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace xgm::exchange
