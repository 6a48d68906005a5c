// SPDX-License-Identifier: Apache-2.0
#include "stage/misbehaviour.hpp"

#include <algorithm>
#include <new>
#include <opencv2/core.hpp>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

constexpr const char* kNoMemory =
    "not enough memory; use a smaller image, a narrower disparity range or a pyramid";
constexpr const char* kRemedy = "; correct the plugin, or use another one";

/// Of an exception that is none of xgm. Messages are one line.
std::string failure_of(const StagePlace& stage, std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  return name_of(stage) + " failed: " + what + kRemedy;
}

}  // namespace

StagePlace place_of(std::string_view kind, const std::string& plugin) {
  StagePlace place;
  place.kind = kind;
  place.plugin = plugin;
  return place;
}

std::string name_of(const StagePlace& stage) { return stage.kind + " '" + stage.plugin + "'"; }

void require_none(const std::optional<Fault>& fault, const StagePlace& stage) {
  if (!fault) return;
  throw Error(stage.path,
              name_of(stage) + " returned a faulty result: " + to_string(*fault) + kRemedy);
}

void rethrow_as_error(const StagePlace& stage) {
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    if (!error.stage_path().empty()) throw;
    throw Error(stage.path, error.message());
  } catch (const std::bad_alloc&) {
    throw Error(stage.path, kNoMemory);
  } catch (const cv::Exception& error) {  // its what() is about files of OpenCV
    if (error.code == cv::Error::StsNoMem) throw Error(stage.path, kNoMemory);
    throw Error(stage.path, failure_of(stage, "OpenCV says '" + error.err + "'"));
  } catch (const std::exception& error) {
    throw Error(stage.path, failure_of(stage, error.what()));
  } catch (...) {
    throw Error(stage.path, failure_of(stage, "it threw what is no std::exception"));
  }
}

}  // namespace xgm
